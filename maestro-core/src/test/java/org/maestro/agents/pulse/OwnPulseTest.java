package org.maestro.agents.pulse;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import jade.core.IMTPException;
import java.time.Duration;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.maestro.rats.time.SteppedClock;

/** On a clock that the test moves; the network is a lambda. */
class OwnPulseTest {
  private static final HeartbeatSettings SETTINGS = HeartbeatSettings.standard();

  private final SteppedClock clock = new SteppedClock();
  private final AtomicInteger beats = new AtomicInteger();
  private final AtomicInteger givenUp = new AtomicInteger();
  private volatile boolean cut;
  private volatile boolean welcome = true;
  private volatile SortedMap<String, Duration> lastSilent = new TreeMap<>();

  private final OwnPulse pulse =
      new OwnPulse(
          (life, silent) -> {
            beats.incrementAndGet();
            lastSilent = silent;
            if (cut) {
              throw new IMTPException("The link is cut");
            }
            return Confirmation.of(SETTINGS, welcome).write();
          });

  @AfterEach
  void end() {
    pulse.end();
  }

  @Test
  void whileItIsConfirmedItMayActAndAfterTheLeaseNotBeforeItIsReplaced() {
    enlist("lamp", Runnable::run);
    beat(8);
    assertThat(pulse.isCutOff()).isFalse();

    cut = true;
    beat(6);
    assertThat(pulse.isCutOff()).as("within the lease").isFalse();
    pass(SETTINGS.period().multipliedBy(2));
    assertThat(pulse.isCutOff()).as("before it is given up after 4 s").isTrue();
  }

  @Test
  void whoWasGivenUpIsToldOnceAndBeginsNothing() {
    pulse.whenGivenUp(givenUp::incrementAndGet);
    enlist("lamp", Runnable::run);
    beat(2);
    welcome = false;
    pass(SETTINGS.period());
    await().until(() -> givenUp.get() == 1);

    assertThat(pulse.isCutOff()).isTrue();
    pass(Duration.ofSeconds(20));
    assertThat(givenUp).hasValue(1);
  }

  @Test
  void whoHearsNobodyForLongGivesThePlatformUp() {
    pulse.whenGivenUp(givenUp::incrementAndGet);
    enlist("lamp", Runnable::run);
    cut = true;
    pass(Duration.ofSeconds(20));

    await().until(() -> givenUp.get() == 1);
  }

  @Test
  void anAgentThatHangsIsTold() {
    enlist("lamp", Runnable::run);
    enlist("rose", work -> {});
    beat(6);

    assertThat(lastSilent).containsOnlyKeys("rose");
  }

  private void enlist(String name, Consumer<Runnable> tell) {
    pulse.enlist(name, tell, () -> {}, clock);
    pass(Duration.ofMillis(1));
    await().pollInterval(Duration.ofMillis(2)).until(pulse::isQuiet);
  }

  /** The beats go out on a thread of their own; each has arrived before time passes on. */
  private void beat(int times) {
    for (int i = 0; i < times; i++) {
      int before = beats.get();
      pass(SETTINGS.period());
      await().pollInterval(Duration.ofMillis(2)).until(() -> beats.get() > before);
      await().pollInterval(Duration.ofMillis(2)).until(pulse::isQuiet);
    }
  }

  private void pass(Duration duration) {
    boolean[] passed = {false};
    clock.schedule(duration, "test", () -> passed[0] = true);
    clock.runUntil(() -> passed[0], duration.plusSeconds(1));
  }
}
