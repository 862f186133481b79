package org.maestro.coordination.scripts;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.maestro.coordination.api.AnswerRefusal;
import org.maestro.coordination.api.GoalId;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalPriority;
import org.maestro.coordination.api.GoalRequest;
import org.maestro.coordination.api.GoalState;
import org.maestro.coordination.api.GoalStatus;
import org.maestro.coordination.api.Ports;
import org.maestro.coordination.api.Recovery;
import org.maestro.coordination.api.Respondent;
import org.maestro.coordination.api.Stakes;
import org.maestro.coordination.api.Story;
import org.maestro.coordination.api.WaitsFor;
import org.maestro.coordination.contention.ActiveGoal;
import org.maestro.coordination.contention.ActiveGoals;
import org.maestro.coordination.contention.GoalOfGoals;
import org.maestro.coordination.facts.FactFilter;
import org.maestro.coordination.recovery.FormerCalls;
import org.maestro.coordination.story.GoalLife;
import org.maestro.coordination.story.GoalPhase;
import org.maestro.coordination.story.GoalStory;
import org.maestro.coordination.story.PlanRecords;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.ontology.home.Script;
import org.maestro.sl.Body;
import org.maestro.sl.Formula;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/**
 * A script that is carried out: a goal that is reached when its last part is over (ADE, 4.1 and 5;
 * A58, A75). It holds nothing itself; the goals for its parts contend with others as any goal does.
 * The coordinator's thread only.
 */
public final class ScriptGoal implements GoalOfGoals {
  private static final String ROOT = "";

  /** Where it is noted that it is to be cancelled, and why; no part has that path. */
  private static final String CANCELLED = "0";

  /** Who has come back tells of itself within this time; what is not known by then is not so. */
  public static final Duration TELLING = Duration.ofSeconds(1);

  private final GoalLife life;
  private final GoalStory story;
  private final ActiveGoals activeGoals;
  private final Course course;
  private final Part root;
  private Optional<GoalState> ending = Optional.empty();
  private Optional<Runnable> onceRecovered = Optional.empty();

  /**
   * @param request its goal is an atom: the script's name, with values for its parameters
   */
  public ScriptGoal(
      String id,
      GoalRequest request,
      Script script,
      GoalPriority standing,
      Ports ports,
      ActiveGoals activeGoals,
      Subgoals subgoals,
      Consumer<GoalOutcome> ended) {
    this.activeGoals = activeGoals;
    this.story = new GoalStory(id, ports.story(), ports.clock(), ports.knowledge());
    this.life = new GoalLife(id, request, ports, story, ended);
    this.course =
        new Course(id, request, standing, ports, activeGoals, subgoals, Parts::of, this::partEnded);
    List<Term> arguments = ((Formula.Atom) request.goal()).arguments();
    Body.Seq steps =
        script.body() instanceof Body.Seq seq ? seq : new Body.Seq(List.of(script.body()));
    course.steps().laidOut(steps);
    story.plans().follow(course.steps()::all);
    this.root = course.part(steps, Course.scope(script, arguments, 1), ROOT, this::ended);
  }

  /**
   * The story of a script that is carried out for a step of a plan: part of that of the whole.
   *
   * @param id of the script as a goal, which is part of another
   */
  public static Story storyOfPart(String id, Ports ports) {
    String whole = GoalId.whole(id);
    return new ScriptStory(whole, ports).of(id.substring(whole.length() + 1));
  }

  /** The script that a goal asks for, if it does. */
  public static Optional<Script> script(Formula goal, Map<String, Script> scripts) {
    return goal instanceof Formula.Atom atom
        ? Optional.ofNullable(scripts.get(atom.predicate()))
        : Optional.empty();
  }

  /** The request, with what the script that it asks for is worth where nothing else is stated. */
  public static GoalRequest weighed(GoalRequest request, Map<String, Script> scripts) {
    if (request.stakes().isPresent()) {
      return request;
    }
    return script(request.goal(), scripts)
        .flatMap(script -> stakes(script, ((Formula.Atom) request.goal()).arguments()))
        .map(request::with)
        .orElse(request);
  }

  private static Optional<Stakes> stakes(Script script, List<Term> arguments) {
    if (arguments.size() != script.parameters().size()) {
      return Optional.empty();
    }
    Scope scope = Course.scope(script, arguments, 1);
    return Stakes.of(script.worth(), scope::apply);
  }

  @Override
  public void start() {
    if (!life.isOver()) {
      story.submitted(life.request(), "the script " + SlPrinter.print(life.request().goal()));
      life.become(GoalPhase.CARRYING_OUT, "");
      course.ready(Optional.empty());
      root.begin();
    }
  }

  @Override
  public void prepareToTakeUp(Recovery.UnfinishedGoal goal, String awaited) {
    life.takeUp(goal);
    course.prepareToTakeUp(goal);
    life.become(GoalPhase.RECOVERING, awaited);
  }

  @Override
  public void takeUp(Recovery.UnfinishedGoal goal, FormerCalls former) {
    if (life.isOver()) {
      return;
    }
    story.takenUp(goal);
    root.begin();
    course.after(TELLING, () -> goOn(former));
  }

  private void goOn(FormerCalls former) {
    if (life.isOver()) {
      return;
    }
    life.become(GoalPhase.CARRYING_OUT, "");
    course.ready(Optional.of(former));
    course
        .notes()
        .value(CANCELLED)
        .ifPresentOrElse(
            why -> endEarly(GoalState.CANCELLED, ((Term.Text) why).value()),
            () -> onceRecovered.ifPresent(Runnable::run));
  }

  /**
   * Takes an answer to a question of one of its parts.
   *
   * @param then told once why it is not taken; nothing when it is, and is being written down
   */
  public void answer(
      String part, String text, Respondent by, Consumer<Optional<AnswerRefusal>> then) {
    course.voice().answer(part.substring(id().length() + 1), text, by, then);
  }

  private void partEnded(GoalOutcome part) {
    if (!life.isOver()) {
      life.add(part);
    }
  }

  private void ended(Result result) {
    if (life.isOver()) {
      return;
    }
    if (result instanceof Result.Failed failed) {
      end(GoalState.FAILED, Map.of(), List.of(failed.reason()));
    } else {
      end(
          GoalState.ACHIEVED,
          result.given().map(value -> Map.of("result", value)).orElse(Map.of()),
          course.isUnseen()
              ? List.of("What was done for it is so as those say who did it.")
              : List.of());
    }
  }

  private void end(GoalState how, Map<String, Term> binding, List<String> reasons) {
    life.become(GoalPhase.ENDING);
    life.end(how, how == GoalState.ACHIEVED && !course.isUnseen(), binding, reasons);
    activeGoals.leave(life.id());
  }

  @Override
  public void cancel(String who) {
    course.notes().value(CANCELLED, new Term.Text("Cancelled by " + who + "."));
    endEarly(GoalState.CANCELLED, "Cancelled by " + who + ".");
  }

  @Override
  public void deadlinePassed() {
    endEarly(GoalState.FAILED, "Its deadline has passed" + life.standingInWords() + ".");
  }

  /** What is to be done in any case is done first. */
  private void endEarly(GoalState how, String reason) {
    if (life.isOver() || ending.isPresent()) {
      return;
    }
    if (life.phase() == GoalPhase.RECOVERING) {
      onceRecovered = Optional.of(() -> endEarly(how, reason));
      return;
    }
    ending = Optional.of(how);
    life.become(GoalPhase.CARRYING_OUT, "it is being ended");
    root.callOff(() -> end(how, Map.of(), List.of(reason)));
  }

  @Override
  public String id() {
    return life.id();
  }

  @Override
  public GoalStatus status() {
    List<GoalStatus> parts = course.underway().stream().map(ActiveGoal::status).toList();
    List<WaitsFor> waits = parts.stream().flatMap(part -> part.waits().stream()).toList();
    GoalStatus own = life.status(waits).worth(activeGoals.appraisals().find(id()));
    List<String> questions = course.voice().openQuestions();
    if (own.state() != GoalState.RUNNING || parts.isEmpty() && questions.isEmpty()) {
      return own;
    }
    boolean allWait =
        parts.stream()
            .allMatch(
                part -> part.state() == GoalState.WAITING || part.state() == GoalState.SUSPENDED);
    GoalState waiting = parts.isEmpty() ? GoalState.WAITING : parts.get(0).state();
    Stream<String> steps =
        parts.stream()
            .map(
                part ->
                    "step "
                        + part.id().substring(id().length() + 1)
                        + (part.detail().isEmpty() ? "" : ": " + part.detail()));
    return own.as(
        allWait ? waiting : own.state(),
        Stream.concat(steps, questions.stream()).collect(Collectors.joining("; ")));
  }

  @Override
  public PlanRecords plans() {
    return story.plans();
  }

  @Override
  public void knowledgeChanged(KnowledgeBase.Change change, FactFilter changed) {
    course.knowledgeChanged(changed);
  }

  @Override
  public double remainingSeconds() {
    return course.underway().stream().mapToDouble(ActiveGoal::remainingSeconds).sum();
  }

  @Override
  public OptionalDouble remainingCost() {
    return course.underway().isEmpty()
        ? OptionalDouble.empty()
        : OptionalDouble.of(
            course.underway().stream().mapToDouble(part -> part.remainingCost().orElse(0)).sum());
  }

  @Override
  public Duration pursuedSince() {
    return life.submittedAt();
  }
}
