#include "api/door/dds/loopback_transport.h"

#include <fastdds/rtps/network/SenderResource.h>
#include <fastdds/rtps/transport/ChainingTransport.h>
#include <fastdds/rtps/transport/TransportReceiverInterface.h>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastrtps/utils/IPLocator.h>

namespace slackwater::dds {
namespace {

namespace transport = eprosima::fastdds::rtps;
namespace rtps = eprosima::fastrtps::rtps;

std::shared_ptr<transport::TransportDescriptorInterface> udp_on_loopback() {
  auto udp = std::make_shared<transport::UDPv4TransportDescriptor>();
  udp->interfaceWhiteList.emplace_back("127.0.0.1");
  return udp;
}

class LoopbackTransport final : public transport::ChainingTransport {
 public:
  explicit LoopbackTransport(const LoopbackTransportDescriptor& descriptor)
      : ChainingTransport(descriptor), descriptor_(descriptor) {}

  transport::TransportDescriptorInterface* get_configuration() override { return &descriptor_; }

  bool transform_remote_locator(const rtps::Locator_t& remote,
                                rtps::Locator_t& result) const override {
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
    above->OnDataReceived(bytes, size, local, remote);
  }

 private:
  LoopbackTransportDescriptor descriptor_;
};

}  // namespace

LoopbackTransportDescriptor::LoopbackTransportDescriptor()
    : ChainingTransportDescriptor(udp_on_loopback()) {}

transport::TransportInterface* LoopbackTransportDescriptor::create_transport() const {
  return new LoopbackTransport(*this);
}

}  // namespace slackwater::dds
