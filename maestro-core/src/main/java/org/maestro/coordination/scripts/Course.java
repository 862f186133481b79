package org.maestro.coordination.scripts;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import java.util.function.Function;
import org.maestro.coordination.achievement.FeatureCall;
import org.maestro.coordination.api.GoalId;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalPriority;
import org.maestro.coordination.api.GoalRequest;
import org.maestro.coordination.api.JournalEntry;
import org.maestro.coordination.api.Ports;
import org.maestro.coordination.api.Recovery;
import org.maestro.coordination.api.Resource;
import org.maestro.coordination.contention.ActiveGoal;
import org.maestro.coordination.contention.ActiveGoals;
import org.maestro.coordination.facts.FactFilter;
import org.maestro.coordination.recovery.FormerCalls;
import org.maestro.knowledge.api.Source;
import org.maestro.ontology.home.Script;
import org.maestro.rats.time.Clock;
import org.maestro.sl.Body;
import org.maestro.sl.Change;
import org.maestro.sl.Effect;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;
import org.maestro.sl.TypedVariable;

/**
 * The world as the parts of one script see and change it: what is known, goals begun for it, time,
 * and the notes of how far it has come. The coordinator's thread only.
 */
final class Course {
  /** So many scripts may run each other at once. */
  static final int DEEPEST = 32;

  private final String goalId;
  private final GoalRequest whole;
  private final GoalPriority standing;
  private final Ports ports;
  private final ActiveGoals activeGoals;
  private final Subgoals subgoals;
  private final PartMaker parts;
  private final Consumer<GoalOutcome> partEnded;
  private final Notes notes;
  private final Voice voice;
  private final ScriptStory told;
  private final StepsOfScript steps;
  private final Map<String, ActiveGoal> underway = new LinkedHashMap<>();
  private final Map<String, HoldGoal> holds = new LinkedHashMap<>();
  private final Map<String, Recovery.UnfinishedGoal> former = new LinkedHashMap<>();
  private final List<Watching> watched = new ArrayList<>();
  private final List<Runnable> deferred = new ArrayList<>();
  private Optional<FormerCalls> ready = Optional.empty();
  private boolean isReady;
  private boolean unseen;
  private long deeds;

  /** Of those who want to know what is asked for. */
  private final List<FactFilter> readers = new ArrayList<>();

  private record Watching(FactFilter interest, Runnable then) {}

  /**
   * @param partEnded told how each goal for a part has ended
   */
  Course(
      String goalId,
      GoalRequest whole,
      GoalPriority standing,
      Ports ports,
      ActiveGoals activeGoals,
      Subgoals subgoals,
      PartMaker parts,
      Consumer<GoalOutcome> partEnded) {
    this.goalId = goalId;
    this.whole = whole;
    this.standing = standing;
    this.ports = ports;
    this.activeGoals = activeGoals;
    this.subgoals = subgoals;
    this.parts = parts;
    this.partEnded = partEnded;
    this.notes = new Notes(goalId, ports.journal());
    this.told = new ScriptStory(goalId, ports);
    this.steps = new StepsOfScript(ports.clock());
    this.voice = new Voice(ports, activeGoals, whole.goal(), notes, told);
  }

  static Scope scope(Script script, List<Term> arguments, int depth) {
    Map<String, Term> values = new LinkedHashMap<>();
    for (int i = 0; i < arguments.size(); i++) {
      values.put(script.parameters().get(i).name(), arguments.get(i));
    }
    return new Scope(values, depth);
  }

  /** A part of the script that is not begun yet. */
  Part part(Body body, Scope scope, String path, Consumer<Result> then) {
    return parts.part(body, scope, this, path, then);
  }

  Notes notes() {
    return notes;
  }

  ScriptStory told() {
    return told;
  }

  /** What is told of the script as data. */
  StepsOfScript steps() {
    return steps;
  }

  /** By which parts speak to people and agents. */
  Voice voice() {
    return voice;
  }

  /** A part has begun that takes time. */
  void takesTime() {
    deeds++;
  }

  /** Goals that are pursued for parts now. */
  Collection<ActiveGoal> underway() {
    return underway.values();
  }

  /** Whether something was done of which only those say so who did it. */
  boolean isUnseen() {
    return unseen;
  }

  /** How many parts that take time have begun. */
  long deeds() {
    return deeds;
  }

  /** What was under way before a restart; what it has for itself stays so. */
  void prepareToTakeUp(Recovery.UnfinishedGoal goal) {
    notes.takeUp(
        goal.memory().notes(),
        goal.endedParts().stream().map(Recovery.EndedGoal::outcome).toList(),
        goal.parts());
    unseen = goal.endedParts().stream().anyMatch(part -> !part.outcome().confirmed());
    for (Recovery.UnfinishedGoal part : goal.parts()) {
      former.put(part.id(), part);
      activeGoals.keep(part.id(), standing, part.keeps().components());
    }
  }

  /** From now on parts may act. */
  void ready(Optional<FormerCalls> calls) {
    ready = calls;
    isReady = true;
    List<Runnable> now = List.copyOf(deferred);
    deferred.clear();
    now.forEach(Runnable::run);
    former.values().forEach(this::giveUp);
    former.clear();
  }

  /** The script has no such part any more: its home was changed meanwhile. */
  private void giveUp(Recovery.UnfinishedGoal part) {
    part.calls()
        .forEach(
            call ->
                ready.ifPresent(
                    calls -> calls.giveUp(call, "the script has no such step any more")));
    activeGoals.leave(part.id());
  }

  void whenReady(Runnable action) {
    if (isReady) {
      action.run();
    } else {
      deferred.add(action);
    }
  }

  /** After what is at work now. */
  void later(Runnable action) {
    activeGoals.run(action);
  }

  Optional<Script> script(String name) {
    return Optional.ofNullable(ports.knowledge().home().scripts().get(name));
  }

  /** On the clock. */
  Duration now() {
    return ports.clock().now();
  }

  private Evaluation known() {
    return new Evaluation(ports.knowledge().snapshot());
  }

  boolean isKnown(Formula condition, Scope scope) {
    readers.forEach(reader -> reader.addRead(scope.apply(condition)));
    return known().truth(condition, scope.values()) == Truth.TRUE;
  }

  OptionalDouble number(Expression expression, Scope scope) {
    readers.forEach(reader -> reader.add(scope.apply(expression)));
    return known().number(expression, scope.values());
  }

  /** Those of which the condition is known to hold, in the order of the home. */
  List<Term.Name> individuals(TypedVariable variable, Formula condition, Scope scope) {
    return ports.knowledge().snapshot().individuals(variable.className().orElse("")).stream()
        .filter(name -> isKnown(condition, scope.with(variable.name(), name)))
        .toList();
  }

  /**
   * Hears of changes under the condition.
   *
   * @return ends that
   */
  Runnable watch(Formula condition, Scope scope, Runnable then) {
    FactFilter interest = new FactFilter(ports.knowledge().home().vocabulary());
    interest.addRead(scope.apply(condition));
    return watch(interest, then);
  }

  /** Gathers all that is asked for from now on, until it is closed. */
  FactFilter reading() {
    FactFilter reader = new FactFilter(ports.knowledge().home().vocabulary());
    readers.add(reader);
    return reader;
  }

  void closeReading(FactFilter reader) {
    readers.remove(reader);
  }

  /** The same, of changes of all this. */
  Runnable watch(FactFilter interest, Runnable then) {
    Watching watching = new Watching(interest, then);
    watched.add(watching);
    return () -> watched.remove(watching);
  }

  void knowledgeChanged(FactFilter changed) {
    List.copyOf(watched).stream()
        .filter(watching -> watching.interest().isConcernedBy(changed))
        .filter(watched::contains)
        .forEach(watching -> watching.then().run());
  }

  /** Returns what calls it off. */
  Runnable after(Duration time, Runnable then) {
    deeds++;
    Clock.Timer timer =
        ports
            .clock()
            .schedule(time, goalId, () -> ports.owner().execute(() -> activeGoals.run(then)));
    return timer::cancel;
  }

  /** Makes facts known, as the script says. */
  void state(Effect effect, String path) {
    List<String> facts = known().changes(effect, Map.of()).stream().map(Course::fact).toList();
    ports.knowledge().state(new Source(Source.Kind.STATED, notes.partId(path)), facts);
    told.states(path, String.join(", ", facts));
  }

  private static String fact(Change change) {
    if (change instanceof Change.OfTruth truth) {
      String atom = SlPrinter.print(truth.atom());
      return truth.value() ? atom : "(not " + atom + ")";
    }
    Change.OfNumber number = (Change.OfNumber) change;
    String fluent = SlPrinter.print(number.fluent());
    return number.value().isPresent()
        ? "(= %s %s)".formatted(fluent, SlPrinter.print(number.value().getAsDouble()))
        : "(unknown " + fluent + ")";
  }

  void achieve(String path, Formula goal, Consumer<Result> then) {
    told.begins(path, "Achieve " + SlPrinter.print(goal));
    begin(
        path,
        goal,
        then,
        make -> ended -> subgoals.reaching(notes.partId(path), make, ported(path), ended));
  }

  /** A look that begins now; empty when nobody could look for anything. */
  Optional<Sighting> sighting(String thing) {
    return Sighting.of(thing, ports.knowledge());
  }

  void look(String path, Sighting sighting, Consumer<Result> then) {
    told.begins(path, "Look at " + SlPrinter.print(sighting.thing()));
    begin(
        path,
        sighting.goal(),
        result -> {
          if (result instanceof Result.Done) {
            told.sees(path, sighting.facts(ports.knowledge().snapshot()));
          }
          then.accept(result);
        },
        make ->
            ended ->
                subgoals.reaching(
                    notes.partId(path),
                    make,
                    ported(path).with(sighting.since(ports.knowledge())),
                    ended));
  }

  void call(String path, FeatureCall call, Consumer<Result> then) {
    told.begins(path, "%s is to do %s%s".formatted(call.member(), call.feature(), with(call)));
    begin(
        path,
        new Formula.And(List.of()),
        then,
        make -> ended -> subgoals.calling(notes.partId(path), call, make, ported(path), ended));
  }

  /**
   * @param held run once, when nobody else has it
   */
  void hold(String path, Resource component, Runnable held, Consumer<Result> then) {
    told.begins(path, "Keep %s for the steps in it".formatted(component.inWords()));
    begin(
        path,
        new Formula.And(List.of()),
        then,
        make ->
            ended -> {
              HoldGoal hold =
                  new HoldGoal(
                      notes.partId(path),
                      make,
                      component,
                      ports.with(told.ofHolding(path, component.inWords())),
                      activeGoals,
                      held,
                      ended);
              holds.put(path, hold);
              return hold;
            });
  }

  /** The steps are done for which it was held. */
  void letGo(String path) {
    Optional.ofNullable(holds.get(path)).ifPresent(HoldGoal::finish);
  }

  private static String with(FeatureCall call) {
    StringBuilder text = new StringBuilder();
    call.parameters()
        .forEach(
            (name, term) ->
                text.append(" :").append(name).append(' ').append(SlPrinter.print(term)));
    return text.toString();
  }

  private Ports ported(String path) {
    return ports.with(told.of(path));
  }

  private void begin(
      String path,
      Formula goal,
      Consumer<Result> then,
      Function<GoalRequest, Function<Consumer<GoalOutcome>, ActiveGoal>> making) {
    deeds++;
    String id = notes.partId(path);
    GoalRequest request =
        new GoalRequest(goal, whole.requester(), whole.priority(), Optional.empty());
    ActiveGoal part =
        making.apply(request).apply(outcome -> activeGoals.run(() -> ended(path, outcome, then)));
    underway.put(path, part);
    activeGoals.enter(part, standing);
    Recovery.UnfinishedGoal before = former.remove(id);
    if (before != null && ready.isPresent()) {
      if (!holds.containsKey(path)) {
        // Scripts in its plans are its own to take up; what a hold is for are steps of this one.
        former.keySet().removeIf(one -> GoalId.isWithin(one, id));
      }
      part.prepareToTakeUp(before, "for what was under way before the restart");
      part.takeUp(before, ready.get());
    } else {
      ports
          .journal()
          .accept(
              new JournalEntry.Submitted(id, request),
              () -> activeGoals.run(part::start),
              refused -> activeGoals.run(() -> part.cancel("want of room: " + refused)));
    }
  }

  private void ended(String path, GoalOutcome outcome, Consumer<Result> then) {
    underway.remove(path);
    holds.remove(path);
    unseen |= !outcome.confirmed();
    subgoals.over(notes.partId(path));
    partEnded.accept(outcome);
    then.accept(Notes.result(outcome));
  }

  void cancel(String path) {
    Optional.ofNullable(underway.get(path)).ifPresent(part -> part.cancel(GoalId.whole(goalId)));
  }
}
