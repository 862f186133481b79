package org.maestro.rats.faults;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.maestro.rats.member.Execution;
import org.maestro.rats.member.MemberProfile;
import org.maestro.rats.member.Procedure;
import org.maestro.rats.protocol.CostAnswer;
import org.maestro.rats.time.Clock;

/** Counts how often each call had its effect; {@code deed} takes some time, and many at once. */
final class CountingDevice {

  final Map<String, Integer> effects = new ConcurrentHashMap<>();
  final Map<String, Duration> startedAt = new ConcurrentHashMap<>();
  private final String id;
  private final Clock clock;
  private final Duration takes;

  CountingDevice(String id, Clock clock, Duration takes) {
    this.id = id;
    this.clock = clock;
    this.takes = takes;
  }

  MemberProfile profile() {
    Procedure procedure =
        new Procedure() {
          @Override
          public void start(Execution execution) {
            String call = execution.call().id();
            effects.merge(call, 1, Integer::sum);
            startedAt.putIfAbsent(call, clock.now());
            clock.schedule(takes, id, () -> execution.succeed(Map.of()));
          }

          @Override
          public CostAnswer cost(Map<String, Object> parameters) {
            return new CostAnswer(Optional.of(1.0), Optional.of(1.0), Optional.empty());
          }
        };
    return new MemberProfile(
        id,
        "{}",
        Set.of("standby", "busy"),
        "standby",
        Set.of("standby"),
        MemberProfile.byId(
            List.of(
                new MemberProfile.Feature(
                    "deed", Set.of(), Set.of(), false, Optional.empty(), "busy", procedure))));
  }
}
