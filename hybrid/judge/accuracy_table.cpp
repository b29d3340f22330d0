// Written by benchmarks/study/study.py promise: do not edit. Made from
// benchmarks/baselines/accuracy.csv and sections.csv.
// clang-format off
#include "judge/accuracy_table.h"

namespace vasorod {
namespace {

using enum LoadKind;

constexpr AccuracyRow rows[] = {
    {"skin", stretch, 0.0662, 0.05, 0.023},
    {"skin", stretch, 0.0662, 0.2, 0.086},
    {"skin", stretch, 0.1323, 0.05, 0.023},
    {"skin", stretch, 0.1323, 0.2, 0.086},
    {"skin", stretch, 0.2645, 0.05, 0.023},
    {"skin", stretch, 0.2645, 0.2, 0.086},
    {"skin", twist, 0.0662, 0.4808, 0.0012},
    {"skin", twist, 0.1323, 0.4808, 0.0012},
    {"skin", twist, 0.2645, 0.4808, 0.0012},
    {"skin", bend, 0.0662, 0.08161, 0.0032},
    {"skin", bend, 0.0662, 0.204, 0.015},
    {"skin", bend, 0.0662, 0.4081, 0.059},
    {"skin", bend, 0.0662, 0.5713, 0.13},
    {"skin", bend, 0.1323, 0.08161, 0.0032},
    {"skin", bend, 0.1323, 0.204, 0.015},
    {"skin", bend, 0.1323, 0.4081, 0.059},
    {"skin", bend, 0.1323, 0.5713, 0.13},
    {"skin", bend, 0.2645, 0.08161, 0.0032},
    {"skin", bend, 0.2645, 0.204, 0.015},
    {"skin", bend, 0.2645, 0.4081, 0.059},
    {"skin", bend, 0.2645, 0.5713, 0.13},
    {"paper", stretch, 0.0662, 0.05, 0.0025},
    {"paper", stretch, 0.0662, 0.2, 0.0077},
    {"paper", stretch, 0.1323, 0.05, 0.0022},
    {"paper", stretch, 0.1323, 0.2, 0.0064},
    {"paper", stretch, 0.2645, 0.05, 0.0017},
    {"paper", stretch, 0.2645, 0.2, 0.0051},
    {"paper", twist, 0.0662, 0.4808, 0.0031},
    {"paper", twist, 0.1323, 0.4808, 0.0029},
    {"paper", twist, 0.2645, 0.4808, 0.0022},
    {"paper", bend, 0.0662, 0.08161, 0.0013},
    {"paper", bend, 0.0662, 0.204, 0.0076},
    {"paper", bend, 0.0662, 0.4081, 0.033},
    {"paper", bend, 0.0662, 0.5713, 0.075},
    {"paper", bend, 0.1323, 0.08161, 0.0013},
    {"paper", bend, 0.1323, 0.204, 0.0076},
    {"paper", bend, 0.1323, 0.4081, 0.033},
    {"paper", bend, 0.1323, 0.5713, 0.075},
    {"paper", bend, 0.2645, 0.08161, 0.0013},
    {"paper", bend, 0.2645, 0.204, 0.0076},
    {"paper", bend, 0.2645, 0.4081, 0.033},
    {"paper", bend, 0.2645, 0.5713, 0.075},
    {"section", stretch, 0.1323, 0.05, 0.0007},
    {"section", stretch, 0.1323, 0.2, 0.0028},
    {"section", stretch, 0.2645, 0.05, 0.00069},
    {"section", stretch, 0.2645, 0.2, 0.0027},
    {"section", twist, 0.1323, 0.4808, 5.1e-05},
    {"section", twist, 0.2645, 0.4808, 0.00019},
    {"section", bend, 0.1323, 0.08161, 0.00014},
    {"section", bend, 0.1323, 0.204, 0.0004},
    {"section", bend, 0.1323, 0.4081, 0.0012},
    {"section", bend, 0.1323, 0.5713, 0.0029},
    {"section", bend, 0.2645, 0.08161, 0.00015},
    {"section", bend, 0.2645, 0.204, 0.00042},
    {"section", bend, 0.2645, 0.4081, 0.0012},
    {"section", bend, 0.2645, 0.5713, 0.0029},
    {"coupled", stretch, 0.0662, 0.05, 0.00035},
    {"coupled", stretch, 0.0662, 0.2, 0.0014},
    {"coupled", stretch, 0.1323, 0.05, 0.0005},
    {"coupled", stretch, 0.1323, 0.2, 0.0013},
    {"coupled", stretch, 0.2645, 0.05, 0.00065},
    {"coupled", stretch, 0.2645, 0.2, 0.0015},
    {"coupled", twist, 0.0662, 0.4808, 1.7e-05},
    {"coupled", twist, 0.1323, 0.4808, 3.8e-05},
    {"coupled", twist, 0.2645, 0.4808, 1.8e-05},
    {"coupled", bend, 0.0662, 0.08161, 0.00011},
    {"coupled", bend, 0.0662, 0.204, 0.00027},
    {"coupled", bend, 0.0662, 0.4081, 0.00049},
    {"coupled", bend, 0.0662, 0.5713, 0.0012},
    {"coupled", bend, 0.1323, 0.08161, 0.00012},
    {"coupled", bend, 0.1323, 0.204, 0.00028},
    {"coupled", bend, 0.1323, 0.4081, 0.00053},
    {"coupled", bend, 0.1323, 0.5713, 0.0016},
    {"coupled", bend, 0.2645, 0.08161, 0.00026},
    {"coupled", bend, 0.2645, 0.204, 0.00061},
    {"coupled", bend, 0.2645, 0.4081, 0.0012},
};

}  // namespace

std::span<const AccuracyRow> accuracy_table() {
  return rows;
}

AccuracyScope accuracy_scope() {
  return {{0.05, 0.2}, {10, 10}};
}

}  // namespace vasorod
