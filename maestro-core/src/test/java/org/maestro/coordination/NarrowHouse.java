package org.maestro.coordination;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.maestro.coordination.api.ActionDispatcher;
import org.maestro.coordination.api.ContractNet;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalRequest;
import org.maestro.coordination.api.GoalState;
import org.maestro.coordination.api.GoalStatus;
import org.maestro.coordination.api.Ports;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.coordination.api.Thinking;
import org.maestro.knowledge.CollectiveKnowledge;
import org.maestro.knowledge.api.FeatureRun;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.knowledge.api.Source;
import org.maestro.ontology.home.Home;
import org.maestro.planning.OptimalPlanner;
import org.maestro.planning.api.Planner;
import org.maestro.planning.api.Step;
import org.maestro.rats.time.SteppedClock;
import org.maestro.sl.SlParser;
import org.maestro.sl.Term;

/**
 * Robots in rooms with narrow doors, without devices, bus or agents. It is a strict house: two
 * robots in one door, or two things at once done by one robot, are written down as accidents.
 */
public final class NarrowHouse implements ActionDispatcher {
  private static final int MOST_SENTENCES = 4_000;

  public final SteppedClock clock = new SteppedClock();
  final KnowledgeBase knowledge;
  public final Coordinator coordinator;
  final List<String> story = new ArrayList<>();
  public final List<String> accidents = new ArrayList<>();
  public final List<String> calls = new ArrayList<>();
  public final Map<String, String> place = new TreeMap<>();
  public final Map<String, GoalOutcome> outcomes = new LinkedHashMap<>();
  final Set<String> dead = new TreeSet<>();
  public final Set<String> mute = new TreeSet<>();
  final Letters letters = new Letters();
  double failures;
  private final Random random;
  private final Map<String, String> busy = new TreeMap<>();

  public NarrowHouse(Home home, long seed) {
    this(home, seed, new OptimalPlanner());
  }

  public NarrowHouse(Home home, long seed, Planner planner) {
    random = new Random(seed);
    knowledge = new CollectiveKnowledge(home, clock);
    coordinator =
        new Coordinator(
            new Ports(
                    knowledge,
                    planner,
                    new DescribedPrices(
                        clock,
                        knowledge,
                        this::isPresent,
                        (member, feature) ->
                            new ContractNet.Quote.Priced(seconds(feature), seconds(feature))),
                    this,
                    new Thinking() {
                      @Override
                      public <T> void think(Supplier<T> work, Consumer<T> then) {
                        clock.schedule(
                            Duration.ofMillis(20), "planning", () -> then.accept(work.get()));
                      }
                    },
                    action -> clock.schedule(Duration.ZERO, "owner", action),
                    clock,
                    this::note)
                .with(letters));
    knowledge.watch(
        change ->
            clock.schedule(Duration.ZERO, "knowledge", () -> coordinator.knowledgeChanged(change)));
    home.devices().keySet().forEach(coordinator::memberPresent);
  }

  /** Nothing goes round for ever without anybody noticing. */
  void note(StoryEntry entry) {
    story.add(
        "%6.2f %s %s %s"
            .formatted(entry.at().toMillis() / 1000.0, entry.goalId(), entry.kind(), entry.text()));
    if (story.size() > MOST_SENTENCES) {
      throw new IllegalStateException(
          "It goes round and round: " + story.subList(story.size() - 60, story.size()));
    }
  }

  public NarrowHouse with(String thing, String zone) {
    place.put(thing, zone);
    knowledge.state(
        new Source(
            Source.Kind.STATED, knowledge.home().devices().containsKey(thing) ? thing : "us"),
        List.of("(in %s %s)".formatted(thing, zone)));
    return this;
  }

  public String wish(String goal) {
    return wish(goal, 0, Optional.empty());
  }

  public String wish(String goal, int priority, Optional<Duration> deadline) {
    return wish(new GoalRequest(SlParser.formula(goal), "Bob", priority, deadline));
  }

  String wish(GoalRequest request) {
    return coordinator.submit(request, outcome -> outcomes.put(outcome.id(), outcome));
  }

  /** Returns whether all wishes have come to an end. */
  public boolean run(int wishes, Duration limit) {
    clock.runUntil(() -> outcomes.size() == wishes, limit);
    return outcomes.size() == wishes;
  }

  public GoalState state(String goal) {
    return status(goal).state();
  }

  public GoalStatus status(String goal) {
    return coordinator.goals().stream().filter(g -> g.id().equals(goal)).findFirst().orElseThrow();
  }

  private boolean isPresent(String member) {
    return coordinator.isPresent(member);
  }

  public String told() {
    return String.join("\n", story);
  }

  public void die(String robot) {
    dead.add(robot);
    busy.values().removeIf(robot::equals);
    coordinator.memberLost(robot, "no power");
  }

  boolean isBusy(Step step) {
    return step.feature().occupies().stream()
        .anyMatch(component -> busy.containsKey(step.member() + " " + component));
  }

  private static double seconds(String procedure) {
    return procedure.equals("move") ? 5 : procedure.equals("pick") ? 4 : 3;
  }

  @Override
  public Handle perform(Request order, Consumer<Report> reported) {
    Step step = order.step();
    String robot = step.member();
    calls.add(step.feature().procedure() + " " + robot);
    List<String> taken = new ArrayList<>();
    step.feature().occupies().forEach(c -> taken.add(robot + " " + c));
    if (step.feature().procedure().equals("move")) {
      taken.add(door(name(step, "from"), name(step, "to")));
    }
    for (String thing : taken) {
      String other = busy.putIfAbsent(thing, robot);
      if (other != null) {
        accidents.add(
            clock.now() + " " + robot + " needs " + thing + ", which " + other + " has: " + order);
      }
    }
    double seconds = seconds(step.feature().procedure()) * (0.5 + random.nextDouble());
    boolean fails = random.nextDouble() < failures;
    clock.schedule(
        Duration.ofMillis((long) (1000 * seconds)),
        robot,
        () -> {
          taken.forEach(thing -> busy.remove(thing, robot));
          if (!mute.contains(robot)) {
            reported.accept(
                fails || dead.contains(robot)
                    ? failed("it went wrong", robot, name(step, "object"))
                    : done(step));
          }
        });
    return () -> {};
  }

  private static String door(String from, String to) {
    return from.compareTo(to) < 0 ? from + to : to + from;
  }

  private Report done(Step step) {
    String robot = step.member();
    String object = name(step, "object");
    switch (step.feature().procedure()) {
      case "move":
        if (!place.get(robot).equals(name(step, "from"))) {
          return failed(robot + " is not there", robot);
        }
        place.put(robot, name(step, "to"));
        return succeeded();
      case "pick":
        if (!place.get(object).equals(place.get(robot)) || place.containsValue(robot)) {
          return failed(object + " cannot be picked", robot, object);
        }
        place.put(object, robot);
        return succeeded();
      default:
        if (!place.get(object).equals(robot)) {
          return failed(object + " is not in the hand", robot, object);
        }
        place.put(object, place.get(robot));
        return succeeded();
    }
  }

  private static String name(Step step, String parameter) {
    return step.bindings().get(parameter) instanceof Term.Name name ? name.text() : "";
  }

  private static Report succeeded() {
    return new Report(true, Map.of(), Optional.empty(), List.of());
  }

  /** A failure tells where these are. */
  private Report failed(String problem, String... things) {
    List<FeatureRun.Learnt> refs =
        List.of(things).stream()
            .filter(place::containsKey)
            .map(
                t ->
                    new FeatureRun.Learnt(
                        "(in %s %s)".formatted(t, place.get(t)), new Term.Truth(true)))
            .toList();
    return new Report(false, Map.of(), Optional.of(problem), refs);
  }
}
