package org.maestro.sim;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Random;
import java.util.TreeMap;
import org.maestro.device.DeviceMember;
import org.maestro.rats.member.RatsMember;
import org.maestro.rats.protocol.Complaints;
import org.maestro.sim.link.BadLink;
import org.maestro.sim.scene.WorldEvent;

/**
 * The RATS members of simulated devices: one is on the bus while its device has power, over a link
 * that may be bad. Any thread may call it.
 */
final class LivingMembers {

  private final SimulatedHome.Setup setup;
  private final Map<String, DeviceMember> members;
  private final Map<String, BadLink> links = new TreeMap<>();
  private final Map<String, RatsMember> running = new LinkedHashMap<>();
  private final Complaints complaints = new Complaints();
  private boolean closed;

  /**
   * @param members by id, in declared order
   */
  LivingMembers(SimulatedHome.Setup setup, Map<String, DeviceMember> members) {
    this.setup = setup;
    this.members = Collections.unmodifiableMap(new LinkedHashMap<>(members));
  }

  /** In declared order. */
  List<String> ids() {
    return List.copyOf(members.keySet());
  }

  /** It joins the bus; it is ready some messages later. */
  void start(String id) {
    DeviceMember member = Objects.requireNonNull(members.get(id));
    RatsMember started =
        RatsMember.start(
            member.profile(),
            member.values(),
            link(id).over(setup.transports().apply(id)),
            setup.site(),
            setup.policy(),
            complaints,
            setup.clock());
    member.motion().whenBarsChange(started::stateChanged);
    synchronized (this) {
      running.put(id, started);
    }
  }

  /** The link of a member, through all its lives. */
  synchronized BadLink link(String id) {
    return links.computeIfAbsent(
        id,
        member ->
            new BadLink(
                member,
                setup.clock(),
                new Random(31 * setup.seed() + List.copyOf(members.keySet()).indexOf(member))));
  }

  /** Dies and comes back with its device's power, and tells what has changed. */
  void follow(WorldEvent event) {
    String subject = event.subject();
    if (event.kind() == WorldEvent.Kind.DIED) {
      removeRunning(subject).ifPresent(RatsMember::die);
    } else if (event.kind() == WorldEvent.Kind.REVIVED && isWanted(subject)) {
      start(subject);
    } else {
      findRunning(subject).ifPresent(this::tellChange);
    }
  }

  /** The change may have been made by any thread; the member belongs to the clock's. */
  private void tellChange(RatsMember member) {
    setup.clock().schedule(Duration.ZERO, member.id(), member::stateChanged);
  }

  private synchronized Optional<RatsMember> findRunning(String id) {
    return Optional.ofNullable(running.get(id));
  }

  private synchronized Optional<RatsMember> removeRunning(String id) {
    return Optional.ofNullable(running.remove(id));
  }

  private synchronized boolean isWanted(String id) {
    return !closed && members.containsKey(id) && !running.containsKey(id);
  }

  /** All leave the bus for good. */
  void close() {
    List<RatsMember> leaving;
    synchronized (this) {
      closed = true;
      leaving = new ArrayList<>(running.values());
      running.clear();
    }
    leaving.forEach(RatsMember::leave);
    leaving.forEach(RatsMember::close);
  }
}
