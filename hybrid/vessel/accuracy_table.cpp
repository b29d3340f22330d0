// Written by benchmarks/study/study.py promise from benchmarks/baselines/accuracy.csv: do not edit.
// clang-format off
#include "vessel/accuracy_table.h"

namespace vasorod {
namespace {

using enum Fidelity;
using enum LoadKind;

constexpr AccuracyRow rows[] = {
    {skin, stretch, 0.0662, 0.05, 0.019},
    {skin, stretch, 0.0662, 0.2, 0.072},
    {skin, stretch, 0.1323, 0.05, 0.019},
    {skin, stretch, 0.1323, 0.2, 0.072},
    {skin, stretch, 0.2645, 0.05, 0.019},
    {skin, stretch, 0.2645, 0.2, 0.072},
    {skin, twist, 0.0662, 0.5053, 0.0002},
    {skin, twist, 0.1323, 0.5053, 0.0002},
    {skin, twist, 0.2645, 0.5053, 0.0002},
    {skin, bend, 0.0662, 0.08161, 0.0018},
    {skin, bend, 0.0662, 0.204, 0.0093},
    {skin, bend, 0.0662, 0.4081, 0.039},
    {skin, bend, 0.0662, 0.5713, 0.083},
    {skin, bend, 0.1323, 0.08161, 0.0018},
    {skin, bend, 0.1323, 0.204, 0.0093},
    {skin, bend, 0.1323, 0.4081, 0.039},
    {skin, bend, 0.1323, 0.5713, 0.083},
    {skin, bend, 0.2645, 0.08161, 0.0018},
    {skin, bend, 0.2645, 0.204, 0.0093},
    {skin, bend, 0.2645, 0.4081, 0.039},
    {skin, bend, 0.2645, 0.5713, 0.083},
    {paper, stretch, 0.0662, 0.05, 0.0014},
    {paper, stretch, 0.0662, 0.2, 0.0041},
    {paper, stretch, 0.1323, 0.05, 0.0013},
    {paper, stretch, 0.1323, 0.2, 0.004},
    {paper, stretch, 0.2645, 0.05, 0.0013},
    {paper, stretch, 0.2645, 0.2, 0.0039},
    {paper, twist, 0.0662, 0.5053, 0.00053},
    {paper, twist, 0.1323, 0.5053, 0.00041},
    {paper, twist, 0.2645, 0.5053, 0.00026},
    {paper, bend, 0.0662, 0.08161, 0.0011},
    {paper, bend, 0.0662, 0.204, 0.0063},
    {paper, bend, 0.0662, 0.4081, 0.028},
    {paper, bend, 0.0662, 0.5713, 0.063},
    {paper, bend, 0.1323, 0.08161, 0.0011},
    {paper, bend, 0.1323, 0.204, 0.0063},
    {paper, bend, 0.1323, 0.4081, 0.028},
    {paper, bend, 0.1323, 0.5713, 0.063},
    {paper, bend, 0.2645, 0.08161, 0.0011},
    {paper, bend, 0.2645, 0.204, 0.0063},
    {paper, bend, 0.2645, 0.4081, 0.028},
    {paper, bend, 0.2645, 0.5713, 0.063},
    {coupled, stretch, 0.1323, 0.05, 0.00022},
    {coupled, stretch, 0.1323, 0.2, 0.00084},
    {coupled, stretch, 0.2645, 0.05, 0.00045},
    {coupled, stretch, 0.2645, 0.2, 0.0011},
    {coupled, twist, 0.1323, 0.5053, 2.4e-06},
    {coupled, twist, 0.2645, 0.5053, 7.2e-06},
    {coupled, bend, 0.1323, 0.08161, 7.6e-05},
    {coupled, bend, 0.1323, 0.204, 0.00023},
    {coupled, bend, 0.1323, 0.4081, 0.00064},
    {coupled, bend, 0.1323, 0.5713, 0.0014},
    {coupled, bend, 0.2645, 0.08161, 0.00014},
    {coupled, bend, 0.2645, 0.204, 0.00037},
    {coupled, bend, 0.2645, 0.4081, 0.00095},
    {coupled, bend, 0.2645, 0.5713, 0.0023},
};

}  // namespace

std::span<const AccuracyRow> accuracy_table() {
  return rows;
}

AccuracyScope accuracy_scope() {
  return {{0.1, 0.1}, {10, 10}};
}

}  // namespace vasorod
