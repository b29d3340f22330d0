// Written by benchmarks/study/study.py promise from benchmarks/baselines/accuracy.csv: do not edit.
#include "vessel/accuracy_table.h"

namespace vasorod {
namespace {

using enum Fidelity;
using enum LoadKind;

constexpr AccuracyRow rows[] = {
    {skin, stretch, 0.0662, 0.05, 0.015},
    {skin, stretch, 0.0662, 0.2, 0.057},
    {skin, stretch, 0.1323, 0.05, 0.015},
    {skin, stretch, 0.1323, 0.2, 0.057},
    {skin, stretch, 0.2645, 0.05, 0.015},
    {skin, stretch, 0.2645, 0.2, 0.057},
    {skin, bend, 0.0662, 0.08161, 0.0015},
    {skin, bend, 0.0662, 0.204, 0.0074},
    {skin, bend, 0.0662, 0.4081, 0.031},
    {skin, bend, 0.0662, 0.5713, 0.067},
    {skin, bend, 0.1323, 0.08161, 0.0015},
    {skin, bend, 0.1323, 0.204, 0.0074},
    {skin, bend, 0.1323, 0.4081, 0.031},
    {skin, bend, 0.1323, 0.5713, 0.067},
    {skin, bend, 0.2645, 0.08161, 0.0015},
    {skin, bend, 0.2645, 0.204, 0.0074},
    {skin, bend, 0.2645, 0.4081, 0.031},
    {skin, bend, 0.2645, 0.5713, 0.067},
    {paper, stretch, 0.0662, 0.05, 0.0011},
    {paper, stretch, 0.0662, 0.2, 0.0033},
    {paper, stretch, 0.1323, 0.05, 0.00097},
    {paper, stretch, 0.1323, 0.2, 0.0032},
    {paper, stretch, 0.2645, 0.05, 0.001},
    {paper, stretch, 0.2645, 0.2, 0.0031},
    {paper, bend, 0.0662, 0.08161, 0.00084},
    {paper, bend, 0.0662, 0.204, 0.0051},
    {paper, bend, 0.0662, 0.4081, 0.022},
    {paper, bend, 0.0662, 0.5713, 0.05},
    {paper, bend, 0.1323, 0.08161, 0.00083},
    {paper, bend, 0.1323, 0.204, 0.0051},
    {paper, bend, 0.1323, 0.4081, 0.022},
    {paper, bend, 0.1323, 0.5713, 0.05},
    {paper, bend, 0.2645, 0.08161, 0.00083},
    {paper, bend, 0.2645, 0.204, 0.0051},
    {paper, bend, 0.2645, 0.4081, 0.022},
    {paper, bend, 0.2645, 0.5713, 0.05},
};

}  // namespace

std::span<const AccuracyRow> accuracy_table() {
  return rows;
}

AccuracyScope accuracy_scope() {
  return {{0.1, 0.1}, {10, 10}};
}

}  // namespace vasorod
