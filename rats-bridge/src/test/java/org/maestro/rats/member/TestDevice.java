package org.maestro.rats.member;

import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import org.maestro.rats.protocol.CostAnswer;
import org.maestro.rats.protocol.ErrorCode;
import org.maestro.rats.protocol.RatsError;
import org.maestro.rats.time.Clock;

/**
 * A device for tests: {@code drive} (base) and {@code grip} (base and arm) take two seconds, {@code
 * wave} (arm) one; {@code watch} is continuous with a value each second, ended by {@code unwatch};
 * {@code echo} answers at once with its parameters; {@code broken} throws.
 */
public final class TestDevice {

  /** What its procedures did, with the clock's seconds. */
  public final List<String> log = new CopyOnWriteArrayList<>();

  public final List<String> facts = new CopyOnWriteArrayList<>(List.of("(level lamp 0)"));
  boolean gripNeverLetsGo;
  boolean gripBreaksOnExit;
  boolean gripFindsItselfJammed;
  private int gripSeconds = 2;
  private final Clock clock;
  private final String id;

  public TestDevice(String id, Clock clock) {
    this.id = id;
    this.clock = clock;
  }

  /** Has {@code grip} take so long. */
  public TestDevice gripping(int seconds) {
    gripSeconds = seconds;
    return this;
  }

  public MemberProfile profile() {
    Map<String, MemberProfile.Feature> features = new LinkedHashMap<>();
    add(features, "drive", Set.of("to"), Set.of("base"), Optional.empty(), timed("drive", 2));
    add(features, "grip", Set.of(), Set.of("base", "arm"), Optional.empty(), gripping());
    add(features, "wave", Set.of(), Set.of("arm"), Optional.empty(), timed("wave", 1));
    add(features, "watch", Set.of("object"), Set.of(), Optional.of("unwatch"), watching());
    add(features, "unwatch", Set.of("object"), Set.of(), Optional.empty(), echo());
    add(features, "echo", Set.of(), Set.of(), Optional.empty(), echo());
    add(features, "broken", Set.of(), Set.of(), Optional.empty(), broken());
    return new MemberProfile(
        id,
        "{\"@id\":\"" + id + "\"}",
        Set.of("standby", "busy", "holding"),
        "standby",
        Set.of("standby"),
        features);
  }

  private void add(
      Map<String, MemberProfile.Feature> features,
      String feature,
      Set<String> required,
      Set<String> occupies,
      Optional<String> endedBy,
      Action action) {
    features.put(
        feature,
        new MemberProfile.Feature(
            feature,
            required,
            occupies,
            endedBy.isPresent(),
            endedBy,
            occupies.isEmpty() ? "standby" : "busy",
            new Procedure() {
              @Override
              public void start(Execution execution) {
                note("start " + feature);
                action.start(execution);
              }

              @Override
              public CostAnswer cost(Map<String, Object> parameters) {
                return new CostAnswer(Optional.of(2.5), Optional.of(2.0), Optional.empty());
              }
            }));
  }

  private Action timed(String feature, int seconds) {
    return execution ->
        clock.schedule(
            Duration.ofSeconds(seconds),
            id,
            () -> {
              note("end " + feature);
              execution.succeed(Map.of());
            });
  }

  /** Puts things down on cancel, which takes three seconds. */
  private Action gripping() {
    return execution -> {
      execution.onCancel(
          safe -> {
            if (gripBreaksOnExit) {
              throw new IllegalStateException("meant to break");
            }
            if (!gripNeverLetsGo) {
              clock.schedule(
                  Duration.ofSeconds(3),
                  id,
                  () -> {
                    note("put down");
                    safe.run();
                  });
            }
          });
      if (gripFindsItselfJammed) {
        execution.giveBack(
            new RatsError(
                ErrorCode.HARDWARE_FAILURE,
                RatsError.Level.WARNING,
                "the gripper is jammed",
                Optional.empty(),
                List.of(),
                true));
        return;
      }
      execution.progress(0.5);
      timed("grip", gripSeconds).start(execution);
    };
  }

  private Action watching() {
    return execution -> {
      execution.established(Map.of("n", 0));
      observeLater(execution, 1);
    };
  }

  private void observeLater(Execution execution, int number) {
    clock.schedule(
        Duration.ofSeconds(1),
        id,
        () -> {
          if (!execution.ended()) {
            execution.observed(Map.of("n", number));
            observeLater(execution, number + 1);
          }
        });
  }

  private static Action echo() {
    return execution -> execution.succeed(execution.call().parameters());
  }

  private static Action broken() {
    return execution -> {
      throw new IllegalStateException("meant to break");
    };
  }

  private void note(String what) {
    log.add(clock.now().toSeconds() + " " + what);
  }

  private interface Action {
    void start(Execution execution);
  }
}
