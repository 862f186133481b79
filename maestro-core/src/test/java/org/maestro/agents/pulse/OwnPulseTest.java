package org.maestro.agents.pulse;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import jade.core.IMTPException;
import java.time.Duration;
import java.util.List;
import java.util.Set;
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
  private volatile Set<String> givenUpContainers = Set.of();
  private volatile Beat last = Beat.read("");

  private final ProcessPulse process = new ProcessPulse();
  private final OwnPulse pulse = new OwnPulse(process, new Road("lights"));
  private final OwnPulse other = new OwnPulse(process, new Road("robots"));

  private final class Road implements OwnPulse.Road {
    private final String container;

    private Road(String container) {
      this.container = container;
    }

    @Override
    public String beat(String text) throws IMTPException {
      beats.incrementAndGet();
      last = Beat.read(text);
      if (cut) {
        throw new IMTPException("The link is cut");
      }
      List<String> unwelcome =
          last.containers().stream()
              .filter(living -> givenUpContainers.contains(living.name()))
              .map(Beat.Living::life)
              .toList();
      return Confirmation.of(SETTINGS, unwelcome).write();
    }

    @Override
    public String container() {
      return container;
    }

    @Override
    public List<String> addresses() {
      return List.of("127.0.0.1:1099");
    }

    @Override
    public boolean isMain() {
      return container.equals("Main-Container");
    }
  }

  @AfterEach
  void end() {
    pulse.end();
    other.end();
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
    givenUpContainers = Set.of("lights");
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

  /** It judges itself: nobody else acts in its place. */
  @Test
  void theProcessOfTheMainContainerDoesNotGiveItselfUp() {
    OwnPulse main = new OwnPulse(process, new Road("Main-Container"));
    main.whenGivenUp(givenUp::incrementAndGet);
    main.enlist("supervisor", Runnable::run, () -> {}, clock);
    enlist("lamp", Runnable::run);
    cut = true;
    pass(Duration.ofSeconds(20));

    assertThat(givenUp).hasValue(0);
    assertThat(pulse.isCutOff()).isFalse();
    main.end();
  }

  @Test
  void anAgentThatHangsIsTold() {
    enlist("lamp", Runnable::run);
    enlist("rose", work -> {});
    beat(6);

    assertThat(last.silences()).containsOnlyKeys("rose");
  }

  @Test
  void theContainersOfAProcessGiveOneSignOfLifeTogether() {
    enlist("lamp", Runnable::run);
    other.enlist("rose", Runnable::run, () -> {}, clock);
    int before = beats.get();
    beat(4);

    assertThat(beats.get() - before).isEqualTo(4);
    assertThat(last.containers()).extracting(Beat.Living::name).containsExactly("lights", "robots");
    assertThat(last.containers().get(0).addresses()).containsExactly("127.0.0.1:1099");
  }

  @Test
  void oneContainerThatIsGivenUpOrEndsLeavesTheOthersAlive() {
    enlist("lamp", Runnable::run);
    other.enlist("rose", Runnable::run, () -> {}, clock);
    givenUpContainers = Set.of("lights");
    beat(2);

    assertThat(pulse.isCutOff()).isTrue();
    assertThat(other.isCutOff()).isFalse();
    assertThat(last.containers()).extracting(Beat.Living::name).containsExactly("robots");
  }

  /** The whole process was frozen: who was asked before could not answer meanwhile. */
  @Test
  void whoThawsDoesNotTakeItsAgentsForThoseThatHang() {
    Duration asked = Duration.ofSeconds(10);
    Census census = new Census();
    census.enlist("rose", work -> {}, () -> {});
    census.ask(asked);
    census.excuse(Duration.ofSeconds(30));

    assertThat(census.silent(asked.plusSeconds(31), SETTINGS.period()))
        .containsEntry("rose", Duration.ofSeconds(1));
  }

  private void enlist(String name, Consumer<Runnable> tell) {
    pulse.enlist(name, tell, () -> {}, clock);
    pass(Duration.ofMillis(1));
    await().pollInterval(Duration.ofMillis(2)).until(process::isQuiet);
  }

  /** The beats go out on a thread of their own; each has arrived before time passes on. */
  private void beat(int times) {
    for (int i = 0; i < times; i++) {
      int before = beats.get();
      pass(SETTINGS.period());
      await().pollInterval(Duration.ofMillis(2)).until(() -> beats.get() > before);
      await().pollInterval(Duration.ofMillis(2)).until(process::isQuiet);
    }
  }

  private void pass(Duration duration) {
    boolean[] passed = {false};
    clock.schedule(duration, "test", () -> passed[0] = true);
    clock.runUntil(() -> passed[0], duration.plusSeconds(1));
  }
}
