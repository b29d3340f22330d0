#include "bodies/found_contacts.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vasorod {

void FoundContacts::begin() {
  pressed_.clear();
  for (size_t i = 0; held_ && i < contacts_.size(); ++i)
    if (contacts_[i].multiplier > 0) pressed_.push_back({contacts_[i], slots_[i]});
  contacts_.clear();
  slots_.clear();
  swallowed_ = 0;
  kept_ = Eigen::VectorXd::Zero(multiplier_.size());
}

void FoundContacts::add(ContactPoint contact, Eigen::Index slot) {
  contact.multiplier = kept_[slot] = multiplier_[slot];
  contacts_.push_back(contact);
  slots_.push_back(slot);
}

bool FoundContacts::keep(Eigen::Index slot, const Points& slave, const Points& master) {
  const auto last = std::find_if(pressed_.begin(), pressed_.end(),
                                 [slot](const Pressed& one) { return one.slot == slot; });
  if (last == pressed_.end()) return false;
  ContactPoint contact = last->contact;
  stick(contact, slot, slave, master);
  add(contact, slot);
  return true;
}

void FoundContacts::end() {
  multiplier_ = kept_;
  finds_depth_ = false;
}

void FoundContacts::start_parting() {
  depth_ = Eigen::VectorXd::Zero(multiplier_.size());
  finds_depth_ = true;
  allowed_ = 1;
}

double FoundContacts::allowed_depth(Eigen::Index slot, double gap) {
  if (depth_.size() == 0) return 0;
  if (finds_depth_) depth_[slot] = std::min(0.0, gap);
  return allowed_ * depth_[slot];
}

void FoundContacts::stick(ContactPoint& contact, Eigen::Index slot, const Points& slave,
                          const Points& master) const {
  const double pressure = multiplier(slot) - contact.stiffness * gap(contact, slave, master);
  contact.stick = std::max(0.0, pressure) / edge_;
  contact.held = apart(contact, slave, master);
}

void FoundContacts::hold_here(const Points& slave, const Points& master) {
  for (ContactPoint& contact : contacts_)
    if (contact.stick > 0) contact.held = apart(contact, slave, master);
}

double FoundContacts::gap(const ContactPoint& contact, const Points& slave, const Points& master) {
  double gap = contact.normal.dot(slave.row(contact.slave)) - contact.slack;
  for (size_t k = 0; k < 3; ++k)
    gap -= contact.weight[static_cast<int>(k)] * contact.normal.dot(master.row(contact.master[k]));
  return gap;
}

Vec3 FoundContacts::apart(const ContactPoint& contact, const Points& slave, const Points& master) {
  Vec3 apart = slave.row(contact.slave);
  for (size_t k = 0; k < 3; ++k)
    apart -= contact.weight[static_cast<int>(k)] * master.row(contact.master[k]).transpose();
  return apart;
}

double FoundContacts::slip(const ContactPoint& contact, const Points& slave, const Points& master) {
  const Vec3 moved = apart(contact, slave, master) - contact.held;
  return (moved - contact.normal.dot(moved) * contact.normal).norm();
}

std::pair<double, double> FoundContacts::update_multipliers(const Points& slave,
                                                            const Points& master) {
  double change = 0, sum = 0;
  change_before_ = std::exchange(change_, Eigen::VectorXd::Zero(multiplier_.size()));
  for (size_t i = 0; i < contacts_.size(); ++i) {
    ContactPoint& c = contacts_[i];
    const double apart = gap(c, slave, master);
    const double pressure = std::max(0.0, c.multiplier - c.stiffness * apart);
    sum += c.area * pressure;
    if (pressure > 0 && std::abs(apart) <= settled_) continue;
    change += c.area * std::abs(pressure - c.multiplier);
    change_[slots_[i]] = pressure - c.multiplier;
    multiplier_[slots_[i]] = c.multiplier = pressure;
  }
  return {change, sum};
}

FoundContacts::Changes FoundContacts::changes() const {
  if (change_before_.size() == 0) return {};
  return {change_.squaredNorm(), change_before_.squaredNorm(), change_.dot(change_before_)};
}

void FoundContacts::go_on(double times) {
  if (change_.size() == 0) return;
  for (size_t i = 0; i < contacts_.size(); ++i) {
    const Eigen::Index slot = slots_[i];
    contacts_[i].multiplier = multiplier_[slot] =
        std::max(0.0, multiplier_[slot] + times * change_[slot]);
  }
  change_.resize(0);
  change_before_.resize(0);
}

}  // namespace vasorod
