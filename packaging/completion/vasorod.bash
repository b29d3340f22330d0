# bash completion of vasorod, vasorod-fem and vasorod-plan. Commands, options and their values are
# read from the program's own --help, so a new one needs no change here.

# The lines of one section (Options, Subcommands) of a help text on standard input.
_vasorod_section() {
  awk -v section="$1" '
    /^[^ ]/ { inside = index($0, section) == 1; next }
    inside && /^  [^ ]/ { print }'
}

# The commands that a program has.
_vasorod_commands() {
  "$1" --help 2>/dev/null | _vasorod_section Subcommands | awk '{ print $1 }'
}

# The options of a program's command (its own where the command is empty), one a line.
_vasorod_options() {
  # shellcheck disable=SC2086 # an empty command is no argument
  "$1" $2 --help 2>/dev/null | _vasorod_section Options | awk '{ print $1 }' | tr ',' '\n' |
    grep '^-'
}

# The values that an option takes, where its help lists them: --model ENUM:{solid,shell}.
_vasorod_values() {
  # shellcheck disable=SC2086
  "$1" $2 --help 2>/dev/null | _vasorod_section Options |
    awk -v option="$3" '
      { names = "," $1 ","; if (!index(names, "," option ",")) next }
      match($0, /\{[^}]*\}/) {
        list = substr($0, RSTART + 1, RLENGTH - 2)
        # a checked transformer lists name->number pairs
        count = split(list, values, ",")
        for (k = 1; k <= count; ++k) { sub(/->.*/, "", values[k]); print values[k] }
      }'
}

_vasorod() {
  local program=$1 current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]}
  local command='' commands words=''
  commands=$(_vasorod_commands "$program" | tr '\n' ' ')
  if [ "$COMP_CWORD" -gt 1 ]; then
    [[ " $commands" == *" ${COMP_WORDS[1]} "* ]] && command=${COMP_WORDS[1]}
  fi
  # A program without commands takes files from the first word on.
  if [ "$COMP_CWORD" -eq 1 ] && [ -n "$commands" ]; then
    words="$commands $(_vasorod_options "$program" '')"
  elif [[ $current == -* ]]; then
    words=$(_vasorod_options "$program" "$command")
  elif [[ $previous == -* ]]; then
    words=$(_vasorod_values "$program" "$command" "$previous")
  else
    words=
  fi
  # No word: files, which the registration below offers.
  mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current")
}

complete -o bashdefault -o default -F _vasorod vasorod vasorod-fem vasorod-plan
