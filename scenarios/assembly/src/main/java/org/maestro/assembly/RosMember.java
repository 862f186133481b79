package org.maestro.assembly;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import org.maestro.device.DeviceMember;
import org.maestro.rats.member.MemberProfile;
import org.maestro.rats.member.RatsMember;
import org.maestro.rats.time.Clock;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A device behind ROS as a member. It joins when its hardware is first heard; while this is not
 * heard any more it is in its safe state, takes no calls, and tells none of its values, so that
 * they are not known any more. Clock thread; any may end it.
 */
final class RosMember {
  private static final Logger LOG = LoggerFactory.getLogger(RosMember.class);

  private static final Duration LOOKS_EVERY = Duration.ofSeconds(1);

  /** What is over sooner nobody need see to. */
  private static final Duration COMPLAINS_AFTER = Duration.ofSeconds(4);

  private final DeviceMember device;
  private final RosHardware hardware;
  private final Function<MemberProfile.Values, RatsMember> joining;
  private final Clock clock;
  private Optional<RatsMember> member = Optional.empty();
  private Optional<String> fault = Optional.empty();
  private Duration faultSince = Duration.ZERO;
  private boolean complained;
  private boolean ended;

  /**
   * @param joining has the member with these values join the site
   */
  RosMember(
      DeviceMember device,
      RosHardware hardware,
      Function<MemberProfile.Values, RatsMember> joining,
      Clock clock) {
    this.device = device;
    this.hardware = hardware;
    this.joining = joining;
    this.clock = clock;
  }

  /** Looks now, and from time to time. Any thread. */
  void begin() {
    clock.schedule(Duration.ZERO, id(), this::look);
  }

  private String id() {
    return device.profile().id();
  }

  private synchronized void look() {
    if (ended) {
      return;
    }
    Optional<String> before = fault;
    fault = hardware.fault().get();
    if (!fault.equals(before)) {
      faultSince = clock.now();
      complained = false;
    }
    complain();
    if (member.isPresent()) {
      tell(member.get(), before);
    } else if (fault.isEmpty()) {
      member = Optional.of(joining.apply(this::values));
    }
    clock.schedule(LOOKS_EVERY, id(), this::look);
  }

  private void tell(RatsMember joined, Optional<String> before) {
    if (fault.isEmpty() && before.isPresent()) {
      hardware.rest().run();
      device.profile().features().keySet().forEach(joined::enable);
      joined.rest(device.profile().initialState());
    } else if (fault.isPresent() && !fault.equals(before)) {
      String reason = fault.get();
      device.profile().features().keySet().forEach(id -> joined.disable(id, reason));
      joined.rest(device.profile().safeStates().iterator().next());
    } else if (fault.isEmpty()) {
      joined.stateChanged();
    }
  }

  private List<String> values() {
    return hardware.fault().get().isPresent() ? List.of() : device.values().current();
  }

  private void complain() {
    if (fault.isPresent()
        && !complained
        && clock.now().minus(faultSince).compareTo(COMPLAINS_AFTER) >= 0) {
      complained = true;
      LOG.warn("Nothing is known of {}: {}", id(), fault.get());
    }
  }

  /** It stands still, and leaves. */
  synchronized void end() {
    ended = true;
    hardware.rest().run();
    member.ifPresent(RatsMember::leave);
  }

  /** After it has left; waits some seconds at most for what it says last. Any thread. */
  void close() {
    joined().ifPresent(RatsMember::close);
  }

  private synchronized Optional<RatsMember> joined() {
    return member;
  }
}
