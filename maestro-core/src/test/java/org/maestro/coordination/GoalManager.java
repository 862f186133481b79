package org.maestro.coordination;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.maestro.coordination.api.ActionDispatcher;
import org.maestro.coordination.api.ComponentWant;
import org.maestro.coordination.api.ContractNet;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalRequest;
import org.maestro.coordination.api.GoalStatus;
import org.maestro.coordination.api.HeldElsewhere;
import org.maestro.coordination.api.Journal;
import org.maestro.coordination.api.JournalEntry;
import org.maestro.coordination.api.Ports;
import org.maestro.coordination.api.Recovery;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.coordination.api.Thinking;
import org.maestro.coordination.api.WaitsFor;
import org.maestro.coordination.journal.JournalImage;
import org.maestro.members.ComponentArbiter;
import org.maestro.planning.OptimalPlanner;
import org.maestro.sl.SlParser;

/**
 * One of several managers of goals in a narrow house, with the arbiters of its robots between it
 * and them: a coordinator of its own, which may die with all that it knows but its journal.
 */
final class GoalManager {
  private static final Duration ON_ITS_WAY = Duration.ofMillis(1);

  final String name;
  final Map<String, GoalOutcome> outcomes = new LinkedHashMap<>();
  private final NarrowHouse house;
  private final Map<String, ComponentArbiter> arbiters;
  private final Map<String, Known> calls = new HashMap<>();
  private final JournalImage journal = new JournalImage(0);
  private Coordinator coordinator;
  private int life;
  private int wishes;
  private boolean alive;

  GoalManager(String name, NarrowHouse house, Map<String, ComponentArbiter> arbiters) {
    this.name = name;
    this.house = house;
    this.arbiters = arbiters;
    this.coordinator = born();
    house.knowledge.watch(
        change -> later(Duration.ZERO, () -> coordinator.knowledgeChanged(change)));
    robots().forEach(robot -> coordinator.memberPresent(robot, Optional.of("its first life")));
  }

  private Set<String> robots() {
    return arbiters.keySet();
  }

  private Coordinator born() {
    int mine = ++life;
    alive = true;
    return new Coordinator(
        new Ports(
            house.knowledge,
            new OptimalPlanner(),
            new DescribedPrices(
                house.clock,
                house.knowledge,
                robot -> coordinator.isPresent(robot),
                (member, feature) -> new ContractNet.Quote.Priced(4, 4)),
            new Crew(),
            new Thinking() {
              @Override
              public <T> void think(Supplier<T> work, Consumer<T> then) {
                later(mine, Duration.ofMillis(20), () -> then.accept(work.get()));
              }
            },
            action -> later(mine, Duration.ZERO, action),
            house.clock,
            entry -> tell(mine, entry),
            new Journal() {
              @Override
              public void write(JournalEntry entry) {
                if (alive && mine == life) {
                  journal.add(new JournalImage.Dated(house.clock.now(), entry));
                }
              }

              @Override
              public void afterwards(Runnable action) {
                action.run();
              }
            }),
        name + "-");
  }

  private void tell(int mine, StoryEntry entry) {
    if (alive && mine == life) {
      house.note(entry);
    }
  }

  private void later(Duration delay, Runnable action) {
    later(life, delay, action);
  }

  /** Unless it has died meanwhile. */
  private void later(int mine, Duration delay, Runnable action) {
    house.clock.schedule(
        delay,
        name,
        () -> {
          if (alive && mine == life) {
            action.run();
          }
        });
  }

  String wish(String goal, int priority) {
    wishes++;
    return coordinator.submit(
        new GoalRequest(SlParser.formula(goal), "Bob", priority, Optional.empty()), this::over);
  }

  private void over(GoalOutcome outcome) {
    outcomes.put(outcome.id(), outcome);
  }

  GoalStatus status(String goal) {
    return goals().stream().filter(g -> g.id().equals(goal)).findFirst().orElseThrow();
  }

  List<GoalStatus> goals() {
    return coordinator.goals();
  }

  List<WaitsFor> waits() {
    return coordinator.waits();
  }

  boolean isAlive() {
    return alive;
  }

  void die() {
    alive = false;
  }

  /** Another takes its place, with its journal. */
  void live() {
    Recovery left = journal.recovery();
    Recovery recovery =
        new Recovery(wishes, left.goals(), left.ended(), left.unwanted(), left.members());
    coordinator = born();
    coordinator.resume(recovery, Duration.ofSeconds(10), this::over);
    robots().forEach(robot -> coordinator.memberPresent(robot, Optional.of("its first life")));
  }

  void askedToYield(ComponentWant want) {
    later(ON_ITS_WAY, () -> coordinator.wantedElsewhere(want));
  }

  void wantedNoMore(String goal, String robot) {
    later(ON_ITS_WAY, () -> coordinator.wantedNoMore(goal, robot));
  }

  void got(String robot, Set<String> components) {
    later(ON_ITS_WAY, () -> coordinator.gotComponents(robot, components));
  }

  /** A call that a robot knows: who asks again is told what became of it. */
  private static final class Known {
    private final List<Consumer<ActionDispatcher.Report>> waiting = new ArrayList<>();
    private Optional<ActionDispatcher.Report> report = Optional.empty();

    private void tell(Consumer<ActionDispatcher.Report> reported) {
      report.ifPresentOrElse(reported, () -> waiting.add(reported));
    }

    private void over(ActionDispatcher.Report what) {
      report = Optional.of(what);
      waiting.forEach(one -> one.accept(what));
    }
  }

  /** Its orders go by the arbiters of the robots; what it hears of them it hears while it lives. */
  private final class Crew implements ActionDispatcher {
    private final int mine = life;

    private void tell(String robot, Consumer<ComponentArbiter> word) {
      house.clock.schedule(ON_ITS_WAY, robot, () -> word.accept(arbiters.get(robot)));
    }

    private Consumer<Report> whileItLives(Consumer<Report> reported) {
      return report -> {
        if (alive && mine == life) {
          reported.accept(report);
        }
      };
    }

    @Override
    public Handle perform(Request order, Consumer<Report> reported) {
      String robot = order.step().member();
      tell(robot, arbiter -> arrived(order, arbiter, whileItLives(reported)));
      return () -> {};
    }

    private void arrived(Request order, ComponentArbiter arbiter, Consumer<Report> reported) {
      String call = order.call().orElseThrow().id();
      if (calls.containsKey(call)) {
        calls.get(call).tell(reported);
        return;
      }
      Set<String> components = Set.copyOf(order.step().feature().occupies());
      Optional<HeldElsewhere> other =
          order.ends() ? Optional.empty() : arbiter.use(name, order.goalId(), components, true);
      if (order.ends() || other.isPresent()) {
        Report refusal =
            other
                .map(by -> Report.held(by, "It is held by another."))
                .orElseGet(
                    () ->
                        new Report(
                            false, Map.of(), Optional.of("It was never begun."), List.of(), false));
        house.clock.schedule(ON_ITS_WAY, name, () -> reported.accept(refusal));
        return;
      }
      Known known = new Known();
      calls.put(call, known);
      known.tell(reported);
      begin(
          order,
          report -> {
            arbiter.used(components);
            known.over(report);
          });
    }

    /** A robot does one thing after the other: what is left of a former life comes to its end. */
    private void begin(Request order, Consumer<Report> over) {
      if (house.isBusy(order.step())) {
        house.clock.schedule(Duration.ofMillis(100), name, () -> begin(order, over));
      } else {
        house.perform(order, over);
      }
    }

    @Override
    public void want(ComponentWant want) {
      tell(want.member(), arbiter -> arbiter.want(name, want));
    }

    @Override
    public void wantNoMore(String goalId, String member) {
      tell(member, arbiter -> arbiter.wantNoMore(name, goalId));
    }

    @Override
    public void giveBack(String member, Set<String> components) {
      tell(member, arbiter -> arbiter.giveBack(name, components));
    }
  }
}
