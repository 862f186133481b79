package org.maestro.bench.containers;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicInteger;
import org.maestro.rats.member.Execution;
import org.maestro.rats.member.MemberProfile;
import org.maestro.rats.member.Procedure;
import org.maestro.rats.member.RatsMember;
import org.maestro.rats.protocol.CostAnswer;
import org.maestro.rats.time.Clock;
import org.maestro.rats.transport.Transport;

/**
 * A device that can be turned up and down, of a kind that no vocabulary knows; its agent belongs
 * into a container of its own topic.
 */
record Dial(int number) {
  private static final Duration TURNING = Duration.ofMillis(200);
  private static final String STANDBY = "standby";
  private static final String TURNING_STATE = "turning";

  String id() {
    return "dial-" + number;
  }

  static String container(int number) {
    return "host-" + number;
  }

  String isAt(int level) {
    return "(= (level %s) %d)".formatted(id(), level);
  }

  RatsMember join(Transport transport, String site, Clock clock, int containers) {
    AtomicInteger level = new AtomicInteger();
    return RatsMember.start(
        new MemberProfile(
            id(),
            description(container(number % containers)),
            Set.of(STANDBY, TURNING_STATE),
            STANDBY,
            Set.of(STANDBY),
            MemberProfile.byId(
                List.of(
                    feature(clock, "turnUp", () -> level.set(1)),
                    feature(clock, "turnDown", () -> level.set(0))))),
        () -> List.of(isAt(level.get())),
        transport,
        site,
        clock);
  }

  private String description(String container) {
    return """
    {"@context": "https://w3id.org/maestro/context.jsonld",
     "id": "https://example.org/bench#%1$s",
     "type": ["maestro:Device", "https://example.org/bench#Dial"],
     "label": "%1$s", "container": "%2$s",
     "offers": [
       {"id": "https://example.org/bench#turnUp", "type": "maestro:Action",
        "sentence": "{self} is turned up", "occupies": ["knob"],
        "precondition": "(not (= (level ?self) 1))", "effect": "(assign (level ?self) 1)",
        "cost": "1", "seconds": "0.2"},
       {"id": "https://example.org/bench#turnDown", "type": "maestro:Action",
        "sentence": "{self} is turned down", "occupies": ["knob"],
        "precondition": "(not (= (level ?self) 0))", "effect": "(assign (level ?self) 0)",
        "cost": "1", "seconds": "0.2"}]}
    """
        .formatted(id(), container);
  }

  private MemberProfile.Feature feature(Clock clock, String name, Runnable deed) {
    Procedure turn =
        new Procedure() {
          @Override
          public void start(Execution execution) {
            clock.schedule(
                TURNING,
                id(),
                () -> {
                  deed.run();
                  execution.succeed(Map.of());
                });
          }

          @Override
          public CostAnswer cost(Map<String, Object> parameters) {
            return new CostAnswer(Optional.of(1.0), Optional.of(0.2), Optional.empty());
          }
        };
    return new MemberProfile.Feature(
        name, Set.of(), Set.of("knob"), false, Optional.empty(), TURNING_STATE, turn);
  }
}
