#include "sim/exec/gdb/server.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <vector>

#include "sim/exec/gdb/history.h"

namespace robosim::exec::gdb {
namespace {

constexpr std::uint32_t kMostBytes = 0x1000;  // limit of memory bytes in a packet
constexpr const char* kDone = "OK";
constexpr const char* kRefused = "E01";
constexpr const char* kUnknown = "";

std::string to_hex(std::string_view bytes) {
  std::string text;
  for (const char c : bytes) text += fmt::format("{:02x}", static_cast<unsigned char>(c));
  return text;
}

/// Reads the fields of a packet from its front. If the packet is malformed, sound() returns false.
class Fields {
 public:
  explicit Fields(std::string_view text) : text_(text) {}

  std::uint32_t number() {
    std::uint32_t value = 0;
    const auto [end, error] = std::from_chars(text_.data(), text_.data() + text_.size(), value, 16);
    sound_ = sound_ && error == std::errc();
    text_.remove_prefix(static_cast<std::size_t>(end - text_.data()));
    return value;
  }
  void skip(char c) {
    sound_ = sound_ && !text_.empty() && text_.front() == c;
    if (!text_.empty()) text_.remove_prefix(1);
  }
  std::string bytes() {
    std::string result;
    for (std::size_t i = 0; i + 1 < text_.size(); i += 2) {
      unsigned value = 0;
      const char* end = text_.data() + i + 2;
      sound_ = sound_ && std::from_chars(text_.data() + i, end, value, 16).ptr == end;
      result += static_cast<char>(value);
    }
    return result;
  }
  bool sound() const { return sound_; }

 private:
  std::string_view text_;
  bool sound_ = true;
};

bool begins(std::string_view text, std::string_view with) { return text.substr(0, with.size()) == with; }

std::string write_registers(Processor& processor, std::string_view bytes) {
  for (unsigned number = 0; !bytes.empty(); ++number) {
    const std::size_t size = processor.read_register(number).size();
    if (size == 0 || size > bytes.size() || !processor.write_register(number, bytes.substr(0, size)))
      return kRefused;
    bytes.remove_prefix(size);
  }
  return kDone;
}

std::string write_to(Processor& processor, const std::string& packet) {
  Fields fields(std::string_view(packet).substr(1));
  if (packet[0] == 'G') return write_registers(processor, fields.bytes());
  if (packet[0] == 'P') {
    const unsigned number = fields.number();
    fields.skip('=');
    return processor.write_register(number, fields.bytes()) && fields.sound() ? kDone : kRefused;
  }
  const std::uint32_t address = fields.number();
  fields.skip(',');
  const std::uint32_t size = fields.number();
  fields.skip(':');
  const std::string bytes = fields.bytes();
  if (!fields.sound() || bytes.size() != size) return kRefused;
  return processor.write_memory(address, bytes) ? kDone : kRefused;
}

std::string stops(Processor& processor, const std::string& packet) {
  const bool set = packet[0] == 'Z';
  const char kind = packet.size() > 1 ? packet[1] : ' ';
  Fields fields(std::string_view(packet).substr(std::min<std::size_t>(2, packet.size())));
  fields.skip(',');
  const std::uint32_t address = fields.number();
  fields.skip(',');
  const std::uint32_t size = fields.number();
  if (!fields.sound()) return kRefused;
  bool done = false;
  if (kind == '0' || kind == '1') {
    done = processor.set_breakpoint(address, set);
  } else if (kind >= '2' && kind <= '4') {
    done = processor.set_watchpoint(address, size, static_cast<Access>(kind - '0'), set);
  } else {
    return kUnknown;
  }
  return done ? kDone : kRefused;
}

}  // namespace

std::string Server::stop_reply() const {
  const int signal = static_cast<int>(stop_.signal);
  if (stop_.edge != Edge::none)
    return fmt::format("T{:02x}replaylog:{};", signal, stop_.edge == Edge::begin ? "begin" : "end");
  if (!stop_.access) return fmt::format("S{:02x}", signal);
  const char* kinds[] = {"watch", "rwatch", "awatch"};
  return fmt::format("T{:02x}{}:{:x};", signal, kinds[static_cast<int>(*stop_.access) - 2], stop_.address);
}

std::string Server::query(Processor& processor, const std::string& packet) {
  if (begins(packet, "qSupported")) {
    const char* const features = processor.description().empty() ? "" : ";qXfer:features:read+";
    const char* const back = history_ ? ";ReverseStep+;ReverseContinue+" : "";
    return fmt::format("PacketSize={:x};QStartNoAckMode+{}{}", 2 * kMostBytes, features, back);
  }
  if (begins(packet, "qAttached")) return "1";  // after this answer, gdb detaches when it quits
  if (begins(packet, "qRcmd,")) {
    Fields fields(std::string_view(packet).substr(6));
    return to_hex(processor.monitor(fields.bytes()));
  }
  constexpr std::string_view kFeatures = "qXfer:features:read:target.xml:";
  if (begins(packet, kFeatures)) {
    Fields fields(std::string_view(packet).substr(kFeatures.size()));
    const std::uint32_t offset = fields.number();
    fields.skip(',');
    const std::uint32_t size = fields.number();
    const std::string xml = processor.description();
    if (!fields.sound() || offset > xml.size()) return kRefused;
    std::string part = offset + size < xml.size() ? "m" : "l";
    return part += xml.substr(offset, size);
  }
  return kUnknown;
}

/// Executes a packet that writes registers or memory. Refuses the write if the run has gone back in time,
/// because later events have already been reported.
std::string Server::write(Processor& processor, const std::string& packet) {
  if (history_ && !history_->is_at_front()) return kRefused;
  const std::string said = write_to(processor, packet);
  if (history_ && said == kDone) history_->forget();
  return said;
}

std::string Server::answer(Processor& processor, const std::string& packet) {
  Fields fields(std::string_view(packet).substr(1));
  switch (packet[0]) {
    case '?':
      return stop_reply();
    case 'q':
      return query(processor, packet);
    case 'H':
      return kDone;
    case 'g':
      return to_hex(processor.registers());
    case 'p': {
      const std::string bytes = processor.read_register(fields.number());
      return bytes.empty() ? kRefused : to_hex(bytes);
    }
    case 'm': {
      const std::uint32_t address = fields.number();
      fields.skip(',');
      const std::uint32_t size = fields.number();
      if (!fields.sound()) return kRefused;
      const std::string bytes = processor.read_memory(address, std::min(size, kMostBytes));
      return bytes.empty() && size > 0 ? kRefused : to_hex(bytes);
    }
    case 'G':
    case 'P':
    case 'M':
      return write(processor, packet);
    case 'Z':
    case 'z':
      return stops(processor, packet);
    default:
      return kUnknown;
  }
}

std::optional<Server::Order> Server::obey(Processor& processor, const std::string& packet) {
  if (packet == "QStartNoAckMode") {
    connection_.send(kDone);
    connection_.trust();
    return std::nullopt;
  }
  switch (packet[0]) {
    case 'c':
    case 'C':
      return Order::go;
    case 's':
    case 'S':
      return Order::step;
    case 'b':
      if (history_ && packet == "bc") return Order::go_back;
      if (history_ && packet == "bs") return Order::step_back;
      connection_.send(kUnknown);
      return std::nullopt;
    case 'D':
      connection_.send(kDone);
      connection_.close();
      return Order::go;
    case 'k':
      interrupted_.store(true, std::memory_order_relaxed);
      connection_.close();
      return Order::go;
    default:
      connection_.send(answer(processor, packet));
      return std::nullopt;
  }
}

Server::Order Server::stand_still(Processor& processor, const Stop& stop) {
  stop_ = stop;
  if (!met_) {
    connection_.accept();
    met_ = true;
  } else {
    connection_.send(stop_reply());
  }
  while (const auto packet = connection_.receive()) {
    if (packet->empty()) continue;
    if (const auto order = obey(processor, *packet)) return *order;
  }
  return Order::go;
}

void Server::say(const std::string& line) { connection_.send(fmt::format("O{}", to_hex(line + "\n"))); }

void Server::ended(int status) {
  if (!connection_.open()) return;
  connection_.send(fmt::format("W{:02x}", status & 0xFF));
  connection_.close();
}

}  // namespace robosim::exec::gdb
