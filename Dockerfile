# Two stages: the first makes the Debian package of the program, the second installs it.
#   docker build -t vasorod .
#   docker run --rm -v "$PWD:/work" vasorod solve scene.yaml -o result
# Without the finite-element reference, the planner and the Python package, which have packages of
# their own.
FROM debian:bookworm AS build
COPY . /source
WORKDIR /source
RUN ./run package -Ppkg.vasorod.nofem,pkg.vasorod.noplanner,nopython

FROM debian:bookworm-slim
COPY --from=build /source/build-package/vasorod_*.deb /tmp/
RUN apt-get update \
    && apt-get install -y --no-install-recommends /tmp/vasorod_*.deb \
    && rm -rf /var/lib/apt/lists/* /tmp/vasorod_*.deb
WORKDIR /work
ENTRYPOINT ["vasorod"]
CMD ["--help"]
