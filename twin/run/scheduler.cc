#include "twin/run/scheduler.h"

#include <numeric>
#include <utility>

#include "fields/base/check.h"
#include "fields/base/numbers/random.h"

namespace slackwater::twin {

Scheduler::Scheduler(std::uint64_t run_seed, double step_s, std::size_t threads)
    : seed_(run_seed),
      step_s_(step_s),
      call_([this](std::size_t i) { clients_[order_[i]](now_); }),
      pool_(threads) {
  expects(step_s > 0, "a step is longer than nothing");
}

void Scheduler::add_client(Client client) {
  clients_.push_back(std::move(client));
  order_.resize(clients_.size());
}

void Scheduler::draw_order(std::uint64_t step, std::vector<std::size_t>& order) const {
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::uint64_t draw = split_mix_64(seed_ ^ split_mix_64(step));
  for (std::size_t left = order.size(); left > 1; --left) {
    draw = split_mix_64(draw);
    std::swap(order[left - 1], order[draw % left]);
  }
}

std::vector<std::size_t> Scheduler::order_of(std::uint64_t step) const {
  std::vector<std::size_t> order(clients_.size());
  draw_order(step, order);
  return order;
}

void Scheduler::step() {
  now_ = {made_, static_cast<double>(made_) * step_s_, step_s_};
  for (const Client& opening : openings_) opening(now_);
  draw_order(made_, order_);
  pool_.run(order_.size(), call_);
  ++made_;
  for (const Client& barrier : barriers_) barrier(now_);
}

std::uint64_t Scheduler::run(std::uint64_t steps, RunControl& control) {
  control.start_clock(made_);
  while (made_ < steps && control.may_step(made_, step_s_)) step();
  return made_;
}

}  // namespace slackwater::twin
