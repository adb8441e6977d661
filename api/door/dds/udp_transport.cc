#include "api/door/dds/udp_transport.h"

#include <fastdds/rtps/network/SenderResource.h>
#include <fastdds/rtps/transport/ChainingTransport.h>
#include <fastdds/rtps/transport/TransportReceiverInterface.h>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastrtps/utils/IPLocator.h>

namespace slackwater::dds {
namespace {

namespace transport = eprosima::fastdds::rtps;
namespace rtps = eprosima::fastrtps::rtps;

std::shared_ptr<transport::TransportDescriptorInterface> plain_udp(const DomainSettings& settings) {
  auto udp = std::make_shared<transport::UDPv4TransportDescriptor>();
  if (settings.is_loopback_only) udp->interfaceWhiteList.emplace_back("127.0.0.1");
  if (!settings.interface.empty()) udp->interfaceWhiteList.push_back(settings.interface);
  return udp;
}

class UdpTransport final : public transport::ChainingTransport {
 public:
  explicit UdpTransport(const UdpTransportDescriptor& descriptor)
      : ChainingTransport(descriptor), descriptor_(descriptor) {}

  transport::TransportDescriptorInterface* get_configuration() override { return &descriptor_; }

  bool transform_remote_locator(const rtps::Locator_t& remote,
                                rtps::Locator_t& result) const override {
    if (!descriptor_.is_loopback_only)
      return ChainingTransport::transform_remote_locator(remote, result);
    if (!IsLocatorSupported(remote)) return false;
    result = remote;
    if (rtps::IPLocator::isMulticast(remote)) return true;
    // Another machine's is none.
    return is_local_locator(remote) && rtps::IPLocator::setIPv4(result, 127, 0, 0, 1);
  }

  bool send(rtps::SenderResource* below, const rtps::octet* bytes, std::uint32_t size,
            rtps::LocatorsIterator* to, rtps::LocatorsIterator* to_end,
            const std::chrono::steady_clock::time_point& until) override {
    return below->send(bytes, size, to, to_end, until);
  }
  void receive(transport::TransportReceiverInterface* above, const rtps::octet* bytes,
               std::uint32_t size, const rtps::Locator_t& local,
               const rtps::Locator_t& remote) override {
    Bytes changed;
    const auto source = [&remote] { return rtps::IPLocator::toIPv4string(remote); };
    Payload in;
    try {
      in = descriptor_.intake->admit({bytes, size}, source, changed,
                                     std::chrono::steady_clock::now());
    } catch (...) {
      return;  // no memory for it: it is lost, as others are on their way
    }
    if (!in.empty())
      above->OnDataReceived(in.data(), static_cast<std::uint32_t>(in.size()), local, remote);
  }

 private:
  UdpTransportDescriptor descriptor_;
};

}  // namespace

UdpTransportDescriptor::UdpTransportDescriptor(const DomainSettings& settings,
                                               std::shared_ptr<Intake> looks)
    : ChainingTransportDescriptor(plain_udp(settings)),
      is_loopback_only(settings.is_loopback_only),
      intake(std::move(looks)) {}

transport::TransportInterface* UdpTransportDescriptor::create_transport() const {
  return new UdpTransport(*this);
}

}  // namespace slackwater::dds
