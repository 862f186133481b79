package org.maestro.assembly;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.maestro.coordination.Coordinator;
import org.maestro.coordination.api.GivenAnswer;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalRequest;
import org.maestro.coordination.api.GoalState;
import org.maestro.coordination.api.Journal;
import org.maestro.coordination.api.JournalEntry;
import org.maestro.coordination.api.Messenger;
import org.maestro.coordination.api.Mood;
import org.maestro.coordination.api.Ports;
import org.maestro.coordination.api.Respondent;
import org.maestro.coordination.api.Speech;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.coordination.api.Thinking;
import org.maestro.knowledge.CollectiveKnowledge;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.ontology.home.DescriptionReader;
import org.maestro.ontology.home.DescriptionWriter;
import org.maestro.ontology.home.Home;
import org.maestro.planning.OptimalPlanner;
import org.maestro.platform.journal.JournalFile;
import org.maestro.rats.link.BusLink;
import org.maestro.rats.time.SteppedClock;
import org.maestro.rats.transport.InProcessBus;
import org.maestro.rats.transport.Transport;
import org.maestro.sim.SimulatedHome;
import org.maestro.sim.scene.Scene;
import org.maestro.sim.world.World;
import org.maestro.sl.Content;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlPrinter;

/**
 * A site without agents whose coordinator dies and is started again, while its devices live on. On
 * the stepped clock.
 */
final class MortalSite implements AutoCloseable {
  private static final String SITE = "mortal";
  private static final String CONTROLLER = "maestro";
  private static final Duration DECISION = Duration.ofMillis(20);
  private static final Duration ANSWER = Duration.ofSeconds(2);

  final SteppedClock clock = new SteppedClock();
  final InProcessBus bus = new InProcessBus(clock);
  final Map<String, GoalOutcome> outcomes = new LinkedHashMap<>();
  final List<String> accepted = new ArrayList<>();
  final List<StoryEntry> story = new ArrayList<>();
  final List<String> letters = new ArrayList<>();
  final List<String> answered = new ArrayList<>();
  final BusWitness witness = BusWitness.listen(bus.client("witness"), SITE);
  private final Home home;
  private final Path data;
  private final SimulatedHome simulated;
  private Life life;

  MortalSite(Home home, Scene scene, Path data) {
    this.home = home;
    this.data = data;
    simulated =
        SimulatedHome.start(
            new SimulatedHome.Setup(
                home, scene, clock, 1, bus::client, SITE, new DescriptionWriter(home)::write));
  }

  /**
   * @param deathAt the number of the journal's entry with which the coordinator dies
   */
  void begin(int deathAt) {
    life = new Life(deathAt);
  }

  void submit(String goal) {
    if (!life.dead) {
      String id =
          life.coordinator.submit(
              new GoalRequest(SlParser.formula(goal, this::isFluent), "somebody"),
              outcome -> outcomes.put(outcome.id(), outcome));
      life.journal.afterwards(() -> accepted.add(id));
    }
  }

  private boolean isFluent(String name) {
    return home.vocabulary().predicate(name).filter(p -> p.fluent()).isPresent();
  }

  boolean allPresent() {
    return simulated.devices().stream().allMatch(life.coordinator::isPresent);
  }

  boolean isDead() {
    return life.dead;
  }

  boolean allEnded() {
    return outcomes.keySet().containsAll(accepted);
  }

  int written() {
    return life.written;
  }

  void die() {
    life.die();
  }

  /** Takes bytes off the end of what was written. */
  void tear(int bytes) throws IOException {
    try (RandomAccessFile file =
        new RandomAccessFile(data.resolve("journal.jsonl").toFile(), "rw")) {
      file.setLength(file.length() - bytes);
    }
  }

  boolean isHolding() {
    return !life.dead
        && life.coordinator.goals().stream().anyMatch(g -> g.state() == GoalState.HOLDING);
  }

  World world() {
    return simulated.world();
  }

  List<String> goals() {
    return life.coordinator.goals().stream().map(String::valueOf).toList();
  }

  @Override
  public void close() {
    life.die();
    simulated.close();
    witness.close();
  }

  /** One coordinator from its start to its death. */
  private final class Life {
    private final Transport transport = bus.client(CONTROLLER);
    private final BusLink link = BusLink.connect(CONTROLLER, SITE, transport, clock);
    private final KnowledgeBase knowledge = new CollectiveKnowledge(home, clock);
    private final JournalFile file = JournalFile.open(data, clock, MortalSite.this::isFluent);
    private final Journal journal;
    private final Coordinator coordinator;
    private final int deathAt;
    private int written;
    private boolean dead;

    private Life(int deathAt) {
      this.deathAt = deathAt;
      this.journal = new LastWords();
      Deputies deputies = new Deputies(link, clock, knowledge, DescriptionReader.of(home)::read);
      coordinator =
          new Coordinator(
              new Ports(
                      knowledge,
                      new OptimalPlanner(),
                      new LinkContractNet(deputies),
                      new LinkActionDispatcher(deputies, link),
                      new InTurn(),
                      action -> clock.schedule(Duration.ZERO, CONTROLLER, () -> unlessDead(action)),
                      clock,
                      story::add,
                      journal)
                  .with(new Letters()));
      file.recovery().ended().forEach(goal -> outcomes.put(goal.outcome().id(), goal.outcome()));
      coordinator.resume(
          file.recovery(), Duration.ofSeconds(10), outcome -> outcomes.put(outcome.id(), outcome));
      deputies.report(coordinator);
      knowledge.watch(
          change ->
              clock.schedule(
                  Duration.ZERO,
                  CONTROLLER,
                  () -> unlessDead(() -> coordinator.knowledgeChanged(change))));
    }

    private void unlessDead(Runnable action) {
      if (!dead) {
        action.run();
      }
    }

    private void die() {
      dead = true;
      transport.die();
      file.close();
    }

    /** What was said stays so whoever dies. */
    private final class Letters implements Messenger {
      @Override
      public void say(Speech speech, Consumer<Optional<String>> then) {
        send(speech.part() + " " + speech.text(), then);
        if (speech.wanted().isPresent()) {
          clock.schedule(ANSWER, CONTROLLER, () -> unlessDead(() -> answer(speech.part())));
        }
      }

      @Override
      public void show(Mood mood, Consumer<Optional<String>> then) {
        send(mood.part() + " " + mood.word(), then);
      }

      @Override
      public void tell(
          String part, String agent, Content message, Consumer<Optional<String>> then) {
        send(part + " " + SlPrinter.print(message), then);
      }

      @Override
      public void keep(GivenAnswer answer, Runnable then) {
        clock.schedule(DECISION, CONTROLLER, () -> unlessDead(then));
      }

      /** Asked again is who was not told that the answer was taken. */
      private void answer(String part) {
        assertThat(answered).as("answers that were taken").doesNotContain(part);
        coordinator.answer(
            part,
            "yes",
            new Respondent("somebody"),
            refusal -> {
              assertThat(refusal).isEmpty();
              answered.add(part);
            });
      }

      private void send(String letter, Consumer<Optional<String>> then) {
        unlessDead(() -> letters.add(letter));
        clock.schedule(DECISION, CONTROLLER, () -> unlessDead(() -> then.accept(Optional.empty())));
      }
    }

    private final class LastWords implements Journal {
      @Override
      public void write(JournalEntry entry) {
        if (!dead) {
          file.write(entry);
          if (++written == deathAt) {
            die();
          }
        }
      }

      @Override
      public void afterwards(Runnable action) {
        if (!dead) {
          file.afterwards(action);
        }
      }
    }

    private final class InTurn implements Thinking {
      @Override
      public <T> void think(Supplier<T> work, Consumer<T> then) {
        clock.schedule(
            Duration.ZERO,
            CONTROLLER,
            () -> {
              if (!dead) {
                T result = work.get();
                clock.schedule(DECISION, CONTROLLER, () -> unlessDead(() -> then.accept(result)));
              }
            });
      }
    }
  }
}
