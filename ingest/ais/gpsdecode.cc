#include "ingest/ais/gpsdecode.h"

#include <algorithm>
#include <deque>
#include <string>

#include "fields/base/error.h"

namespace slackwater::ingest {
namespace {

/// A message on its way through the decoder.
struct Underway {
  AisMessage message;
  std::string last_sentence;
};

/// Matches what comes out to what went in.
class Matcher {
 public:
  explicit Matcher(const OnDecoded& on_decoded) : on_decoded_(on_decoded) {}

  void sent(AisMessage message, std::string last_sentence) {
    underway_.push_back({std::move(message), std::move(last_sentence)});
  }
  void take(std::string_view line) {
    if (line.starts_with('!')) {
      const auto found = std::find_if(underway_.begin(), underway_.end(), [&](const Underway& one) {
        return one.last_sentence == line;
      });
      if (found == underway_.end()) return;  // an earlier fragment
      is_repeated_ = true;
      settle();
      undecoded_ += static_cast<std::size_t>(found - underway_.begin());
      underway_.erase(underway_.begin(), found);
      current_ = std::move(underway_.front().message);
      underway_.pop_front();
    } else if (line.starts_with('{') && current_) {
      on_decoded_(*current_, line);
      current_.reset();
    }
  }
  /// The message whose sentence was repeated without an answer is one that could not be decoded.
  void settle() {
    undecoded_ += current_ ? 1U : 0U;
    current_.reset();
  }
  [[nodiscard]] std::size_t underway() const noexcept { return underway_.size(); }
  [[nodiscard]] std::size_t undecoded() const noexcept { return undecoded_; }
  [[nodiscard]] bool repeats_sentences() const noexcept { return is_repeated_; }

 private:
  const OnDecoded& on_decoded_;
  std::deque<Underway> underway_;
  std::optional<AisMessage> current_;
  std::size_t undecoded_ = 0;
  bool is_repeated_ = false;
};

}  // namespace

FilterProgram gpsdecode_program() {
  FilterProgram program{{"gpsdecode", "-j", "-s", "-v", "-u"}, "apt install gpsd-clients"};
  program.is_confined = true;
  return program;
}

std::size_t decode_messages(const FilterProgram& decoder, const NextMessage& next,
                            const OnDecoded& on_decoded) {
  Matcher matcher(on_decoded);
  const auto produce = [&](std::string& input) {
    constexpr std::size_t batch_bytes = 4096;
    while (input.size() < batch_bytes) {
      std::optional<AisMessage> message = next();
      if (!message) return false;
      std::vector<std::string> sentences = message->sentences();
      for (const std::string& sentence : sentences) input.append(sentence).append("\r\n");
      matcher.sent(std::move(*message), std::move(sentences.back()));
    }
    return true;
  };
  run_filter(decoder, produce, [&](std::string_view line) { matcher.take(line); });
  matcher.settle();
  if (matcher.underway() != 0) {
    throw Error(ErrorKind::unavailable,
                decoder.command.front() + " lost " + std::to_string(matcher.underway()) +
                    " messages" +
                    (matcher.repeats_sentences() ? "" : " and repeats no sentence (option -v)") +
                    "; expected gpsd 3.22 or later; install it: " + decoder.install_advice);
  }
  return matcher.undecoded();
}

}  // namespace slackwater::ingest
