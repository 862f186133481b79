package org.maestro.coordination;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import java.util.function.DoubleSupplier;
import java.util.function.Function;
import java.util.function.Predicate;
import org.maestro.coordination.api.ActionDispatcher;
import org.maestro.coordination.api.ContractNet;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalRequest;
import org.maestro.coordination.api.Journal;
import org.maestro.coordination.api.JournalEntry;
import org.maestro.coordination.api.Ports;
import org.maestro.coordination.api.Recovery;
import org.maestro.coordination.api.Thinking;
import org.maestro.coordination.journal.JournalImage;
import org.maestro.knowledge.CollectiveKnowledge;
import org.maestro.knowledge.api.FeatureRun;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.knowledge.api.Source;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.planning.OptimalPlanner;
import org.maestro.planning.api.Step;
import org.maestro.rats.time.SteppedClock;
import org.maestro.sl.Expression;
import org.maestro.sl.SlParser;
import org.maestro.sl.Term;

/**
 * Bob's home without devices, bus or agents: the ports of coordination answered from a table of
 * truths.
 */
public final class PretendHouse implements ActionDispatcher {
  private static final Duration USUAL_PLANNING = Duration.ofMillis(20);

  public final SteppedClock clock = new SteppedClock();
  public final KnowledgeBase knowledge;
  public Coordinator coordinator;
  public final List<String> story = new ArrayList<>();
  public final Map<String, String> place = new TreeMap<>();
  public final Map<String, Double> ambientLux = new TreeMap<>();
  final Map<String, Double> level = new TreeMap<>();
  public final Set<String> dead = new TreeSet<>();
  public final List<String> calls = new ArrayList<>();
  public final Set<String> weak = new TreeSet<>();
  final Set<String> heavy = new TreeSet<>();
  public Predicate<String> declines = feature -> false;

  /** Members that name no price, and are known at once to name none. */
  final Set<String> priceless = new TreeSet<>();

  public Consumer<String> beforeCall = call -> {};

  Consumer<Request> ordered = order -> {};

  /** What a member does that is to say once more what it says of itself. */
  Consumer<String> whenAsked = member -> {};

  final List<String> calledOff = new ArrayList<>();
  final List<String> cancelled = new ArrayList<>();

  /** What becomes of the report of a step on its way. */
  BiFunction<Step, Report, Report> reporting = (step, report) -> report;

  public Duration stepTakes = Duration.ofMillis(500);

  /** Of one plan; plans that take longer than usual are made one after the other. */
  Duration planningTakes = USUAL_PLANNING;

  private Duration plannerIsFree = Duration.ZERO;

  /** Members of which nobody hears what became of their steps. */
  final Set<String> mute = new TreeSet<>();

  DoubleSupplier noise = () -> 1;

  /** What becomes of a step by its member and procedure, where it is none of Bob's home. */
  final Map<String, Function<Step, Report>> made = new TreeMap<>();

  private final JournalImage journal = new JournalImage(0);
  private int lives;

  public PretendHouse(Home home) {
    knowledge = new CollectiveKnowledge(home, clock);
    coordinator = coordinator();
    knowledge.watch(
        change ->
            clock.schedule(Duration.ZERO, "knowledge", () -> coordinator.knowledgeChanged(change)));
    place.put("Bob", "zone-a");
    place.put("Cup", "zone-b");
    place.put("rose", "zone-b");
    ambientLux.put("zone-a", 5.0);
    ambientLux.put("zone-b", 17.0);
    for (Device device : home.devices().values()) {
      coordinator.memberPresent(device.id());
      if (has(device, "adjustLight")) {
        setLevel(device.id(), device.id().startsWith("lamp-a") ? 1 : 0);
      }
      if (has(device, "move")) {
        knowledge.state(
            new Source(Source.Kind.STATED, device.id()),
            List.of(
                "(in %s %s)".formatted(device.id(), place.getOrDefault(device.id(), "zone-a"))));
      }
    }
  }

  /** One that does nothing any more when another has taken its place. */
  private Coordinator coordinator() {
    int life = ++lives;
    return new Coordinator(
        new Ports(
            knowledge,
            new OptimalPlanner(),
            new DescribedPrices(
                clock, knowledge, member -> coordinator.isPresent(member), this::quote),
            this,
            new Thinking() {
              @Override
              public <T> void think(java.util.function.Supplier<T> work, Consumer<T> then) {
                clock.schedule(
                    untilPlanned(),
                    "planning",
                    () -> {
                      if (life == lives) {
                        then.accept(work.get());
                      }
                    });
              }
            },
            action ->
                clock.schedule(
                    Duration.ZERO,
                    "owner",
                    () -> {
                      if (life == lives) {
                        action.run();
                      }
                    }),
            clock,
            entry -> {
              if (life == lives) {
                story.add(entry.at() + " " + entry.text());
              }
            },
            new Journal() {
              @Override
              public void write(JournalEntry entry) {
                if (life == lives) {
                  journal.add(new JournalImage.Dated(clock.now(), entry));
                }
              }

              @Override
              public void afterwards(Runnable action) {
                action.run();
              }
            }));
  }

  private Duration untilPlanned() {
    if (planningTakes.equals(USUAL_PLANNING)) {
      return USUAL_PLANNING;
    }
    Duration now = clock.now();
    plannerIsFree = (plannerIsFree.compareTo(now) > 0 ? plannerIsFree : now).plus(planningTakes);
    return plannerIsFree.minus(now);
  }

  Recovery recovery() {
    return journal.recovery();
  }

  /** The coordinator ends, and another goes on; to be called while no step is under way. */
  void restart(Consumer<GoalOutcome> ended) {
    Recovery recovery = recovery();
    coordinator = coordinator();
    coordinator.resume(recovery, Duration.ofSeconds(10), ended);
    recovery.members().forEach(coordinator::memberPresent);
  }

  private static boolean has(Device device, String procedure) {
    return device.features().stream().anyMatch(f -> f.procedure().equals(procedure));
  }

  public GoalOutcome achieve(String goal) {
    List<GoalOutcome> outcome = new ArrayList<>();
    coordinator.submit(new GoalRequest(SlParser.formula(goal), "Bob"), outcome::add);
    clock.runUntil(() -> !outcome.isEmpty(), Duration.ofMinutes(10));
    return outcome.get(0);
  }

  void setLevel(String lamp, double value) {
    level.put(lamp, value);
    knowledge.state(
        new Source(Source.Kind.STATED, lamp), List.of("(= (level %s) %s)".formatted(lamp, value)));
  }

  double lux(String zone) {
    double lux = ambientLux.getOrDefault(zone, 0.0);
    for (Map.Entry<String, Double> lamp : level.entrySet()) {
      lux +=
          (weak.contains(lamp.getKey()) ? 0.7 : 1)
              * lamp.getValue()
              * knowledge
                  .snapshot()
                  .number(
                      new Expression.Fluent(
                          "gain", List.of(new Term.Name(lamp.getKey()), new Term.Name(zone))))
                  .orElse(0);
    }
    return lux;
  }

  private ContractNet.Quote quote(String member, String feature) {
    double price = feature.equals("move") ? 5 : feature.equals("pick") ? 4 : 3;
    if (priceless.contains(member)) {
      return new ContractNet.Quote.Unanswered("is not there");
    }
    return declines.test(feature)
        ? new ContractNet.Quote.Declined("it cannot be done now")
        : new ContractNet.Quote.Priced(price, price);
  }

  /** A sensor tells a value twice a second until it is ended. */
  private void stream(Step step, boolean[] ended) {
    clock.schedule(
        stepTakes,
        step.member(),
        () -> {
          if (!ended[0] && !dead.contains(step.member())) {
            Map<String, Term> bindings = new TreeMap<>(step.bindings());
            bindings.put("self", new Term.Name(step.member()));
            knowledge.learn(
                new FeatureRun(
                    step.member(),
                    step.feature(),
                    bindings,
                    true,
                    done(step).outputs(),
                    List.of()));
            stream(step, ended);
          }
        });
  }

  @Override
  public Handle perform(Request order, Consumer<Report> reported) {
    Step step = order.step();
    boolean[] ended = new boolean[1];
    ordered.accept(order);
    calls.add(step.feature().procedure() + " " + step.member());
    clock.schedule(
        stepTakes,
        step.member(),
        () -> {
          beforeCall.accept(step.feature().procedure() + " " + step.member());
          if (mute.contains(step.member())) {
            return;
          }
          reported.accept(
              dead.contains(step.member())
                  ? failed(step.member() + " does not answer", List.of())
                  : reporting.apply(step, done(step)));
          if (step.feature().procedure().equals("measureIllumination")) {
            stream(step, ended);
          }
        });
    return () -> {
      ended[0] = true;
      cancelled.add(step.feature().procedure() + " " + step.member());
    };
  }

  @Override
  public void ask(String member, Runnable heard) {
    clock.schedule(
        Duration.ofMillis(100),
        member,
        () -> {
          whenAsked.accept(member);
          heard.run();
        });
  }

  @Override
  public void callOff(String member, Call call) {
    calledOff.add(call.id());
  }

  private Report done(Step step) {
    Function<Step, Report> maker = made.get(step.feature().procedure() + " " + step.member());
    return maker == null ? doneInBobsHome(step) : maker.apply(step);
  }

  private Report doneInBobsHome(Step step) {
    String zone = name(step, "zone");
    String object = name(step, "object");
    switch (step.feature().procedure()) {
      case "measureIllumination":
        return succeeded(Map.of("lux", new Term.Number(lux(zone) * noise.getAsDouble())));
      case "adjustLight":
        setLevel(step.member(), ((Term.Number) step.bindings().get("level")).value());
        return succeeded(Map.of());
      case "observeObject":
        if (lux(zone) < 72) {
          return failed(
              "too dark",
              List.of(
                  new FeatureRun.Learnt(
                      "(illuminance %s)".formatted(zone), new Term.Number(lux(zone)))));
        }
        return place.get(object).equals(zone)
            ? succeeded(
                Map.of(
                    "found", new Term.Truth(true), "pose", new Term.Text(position(object, zone))))
            : succeeded(Map.of("found", new Term.Truth(false)));
      case "move":
        place.put(step.member(), name(step, "to"));
        return succeeded(Map.of());
      case "pick":
        if (heavy.contains(object)) {
          return failed(
              "too heavy",
              List.of(new FeatureRun.Learnt("(mass %s)".formatted(object), new Term.Number(3))));
        }
        place.put(object, step.member());
        return succeeded(Map.of());
      case "place":
        place.put(object, zone);
        return succeeded(Map.of());
      default:
        return failed("nobody knows how", List.of());
    }
  }

  private static String position(String object, String zone) {
    double x = zone.equals("zone-a") ? 1.5 : 4.5;
    return (x + (object.equals("Bob") ? 0.4 : 0)) + " 1.5 0";
  }

  private static String name(Step step, String parameter) {
    return step.bindings().get(parameter) instanceof Term.Name name ? name.text() : "";
  }

  static Report succeeded(Map<String, Term> outputs) {
    return new Report(true, outputs, Optional.empty(), List.of());
  }

  static Report failed(String problem, List<FeatureRun.Learnt> refs) {
    return new Report(false, Map.of(), Optional.of(problem), refs);
  }
}
