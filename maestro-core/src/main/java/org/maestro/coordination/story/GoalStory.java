package org.maestro.coordination.story;

import java.time.Duration;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.maestro.coordination.api.BidRecord;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalRequest;
import org.maestro.coordination.api.HeldElsewhere;
import org.maestro.coordination.api.JournalEntry;
import org.maestro.coordination.api.Proposal;
import org.maestro.coordination.api.Recovery;
import org.maestro.coordination.api.SearchReport;
import org.maestro.coordination.api.Sentences;
import org.maestro.coordination.api.Story;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.coordination.api.WaitsFor;
import org.maestro.coordination.api.Worth;
import org.maestro.coordination.facts.Confirmation;
import org.maestro.coordination.lessons.Insistence;
import org.maestro.knowledge.api.Belief;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.knowledge.api.Source;
import org.maestro.ontology.home.Script;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.planning.api.Objective;
import org.maestro.planning.api.Plan;
import org.maestro.planning.api.PlanningResult;
import org.maestro.planning.api.Step;
import org.maestro.rats.time.Clock;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Substitution;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/** Tells one goal's story in sentences as it happens, and keeps its plans as data. */
public final class GoalStory {
  private static final int MOST_FACTS = 6;

  private final String goalId;
  private final Story story;
  private final Clock clock;
  private final KnowledgeBase knowledge;
  private final ProposalSentences bids = new ProposalSentences();
  private final PlanRecords plans;
  private LearntShares learnt = LearntShares.none();

  public GoalStory(String goalId, Story story, Clock clock, KnowledgeBase knowledge) {
    this.goalId = goalId;
    this.story = story;
    this.clock = clock;
    this.knowledge = knowledge;
    this.plans = new PlanRecords(clock);
  }

  /** What it has told of plans and their steps, as data. */
  public PlanRecords plans() {
    return plans;
  }

  public void submitted(GoalRequest request) {
    submitted(request, sentences().fact(request.goal()));
  }

  /**
   * The same.
   *
   * @param what is asked for, in words
   */
  public void submitted(GoalRequest request, String what) {
    tell(StoryEntry.Kind.GOAL, request.requester() + " asks for: " + what + ".");
    Vocabulary vocabulary = knowledge.home().vocabulary();
    List<String> known = knowledge.snapshot().beliefs().stream().map(Belief::fact).toList();
    learnt = LearntShares.of(known, vocabulary);
    KnownOf knownOf =
        new KnownOf(
            knowledge.home(),
            known.stream().filter(LearntShares.isOne(vocabulary).negate()).toList());
    for (String name : names(request)) {
      tell(StoryEntry.Kind.KNOWN, knownOf.sentences(name));
    }
  }

  /** The coordinator ended and another goes on. */
  public void takenUp(Recovery.UnfinishedGoal goal) {
    tell(
        StoryEntry.Kind.RESTART,
        "Taken up again after a restart, "
            + (goal.calls().isEmpty() ? "with nothing under way" : "with steps under way")
            + ".");
  }

  /** What becomes of a call that was under way then; empty: it is asked for again. */
  public void takenUp(Recovery.UnfinishedCall call, Optional<String> obstacle) {
    JournalEntry.Begun begun = call.begun();
    boolean isScript = begun.step().member().equals(Script.PLANNED_AS);
    String step =
        isScript
            ? "Step %d (the script %s)".formatted(begun.number(), begun.step().feature())
            : "Step %d (%s by %s)"
                .formatted(begun.number(), begun.step().feature(), begun.step().member());
    String again =
        isScript
            ? " was under way; it goes on where it was."
            : " was under way; asked for again, which is no second time.";
    tell(
        StoryEntry.Kind.RESTART,
        obstacle
            .map(why -> step + " was under way, and nobody knows what became of it: " + why + ".")
            .orElse(step + again));
  }

  private List<String> names(GoalRequest request) {
    Set<String> words = KnownOf.words(SlPrinter.print(request.goal()));
    return knowledge.home().individuals().keySet().stream().filter(words::contains).toList();
  }

  public void takesWhatIsFree(
      Collection<String> busy, double waitSeconds, double cheapest, double chosen) {
    tell(
        StoryEntry.Kind.PLAN,
        "The plan of cost %s would wait %s for %s; with what is free it costs %s."
            .formatted(
                Sentences.number(cheapest),
                Double.isInfinite(waitSeconds)
                    ? "nobody knows how long"
                    : Sentences.number(waitSeconds) + " seconds or so",
                String.join(", ", busy),
                Sentences.number(chosen)));
  }

  /** A member's agent has refused a step, as another manager has what it needs. */
  public void heldElsewhere(Step step, HeldElsewhere by) {
    plans.notBegun(step);
    tell(
        StoryEntry.Kind.WAIT,
        "Step %d has to wait: %s has what it needs of %s, for %s."
            .formatted(step.number(), by.manager(), step.member(), by.goalId()));
  }

  /** Each thing is told once, until another is waited for. */
  public void waits(List<WaitsFor> obstacles) {
    String text =
        obstacles.stream()
            .map(WaitsFor::inWords)
            .distinct()
            .limit(MOST_FACTS)
            .collect(Collectors.joining(", "));
    tell(StoryEntry.Kind.WAIT, "Waits: " + text + ".");
  }

  /** There is no plan as things are; that may be so for a moment only. */
  public void triesOnceMore(Duration pause, PlanningResult result) {
    tell(
        StoryEntry.Kind.WAIT,
        "No plan as things are. %s It is waited %d s and tried once more."
            .formatted(String.join(" ", reasons(result)), pause.toSeconds()));
  }

  public void awaitsLooks() {
    tell(
        StoryEntry.Kind.WAIT,
        "It is planned again when the looks beside each other have found it, or are over.");
  }

  public void awaitsCertainty(String doubts) {
    tell(
        StoryEntry.Kind.WAIT, "There is no other way, and it is not given up yet: " + doubts + ".");
  }

  public void awaits(String members, Duration atMost) {
    tell(
        StoryEntry.Kind.WAIT,
        "There is no other way, and it is not given up yet: it is waited %s, %d s at most."
            .formatted(members, atMost.toSeconds()));
  }

  public void worth(Worth worth) {
    tell(StoryEntry.Kind.WORTH, "Worth: " + worth.inWords() + learned(worth) + ".");
  }

  private static String learned(Worth worth) {
    return worth.tried() == 0
        ? " (nothing like it was tried)"
        : " (p from %d like it)".formatted(worth.tried());
  }

  public void notWorthIt(Worth worth) {
    tell(
        StoryEntry.Kind.WORTH,
        "It is %s; it is begun when its benefit, its chance or its cost is another."
            .formatted(worth.deficitInWords()));
  }

  public void suspended(String why) {
    tell(StoryEntry.Kind.WAIT, "Stands back: " + why + ".");
  }

  public void goesOn() {
    tell(StoryEntry.Kind.WAIT, "Goes on.");
  }

  public void planning(int number, Optional<String> why) {
    plans.planning(number, why);
    why.ifPresent(reason -> tell(StoryEntry.Kind.REPLAN, "Plan again, because " + reason + "."));
  }

  /** Its outcome follows. */
  public void givenBack(Step step, String reason) {
    tell(
        StoryEntry.Kind.FAILED,
        "%s gives step %d back (%s): %s."
            .formatted(
                step.member(), step.number(), sentence(step), Sentences.withoutFullStop(reason)));
  }

  /**
   * @param answers the same answers, set against the plan
   */
  public void bids(
      List<Proposal> called,
      int notCalled,
      int questions,
      List<String> unpriced,
      List<BidRecord> answers) {
    plans.answered(answers, notCalled);
    tell(StoryEntry.Kind.BIDS, bids.of(called, notCalled, questions, unpriced));
  }

  public void plan(int number, Plan plan, boolean confirming) {
    plans.adopted(plan, confirming, sentences());
    if (plan.steps().isEmpty()) {
      return;
    }
    tell(
        confirming ? StoryEntry.Kind.CONFIRM : StoryEntry.Kind.PLAN,
        "Plan "
            + number
            + " (cost "
            + Sentences.number(plan.cost())
            + "): "
            + sentences().plan(plan.steps())
            + ".");
    learnt
        .news(plan.steps(), this::isKnown, sentences())
        .ifPresent(sentence -> tell(StoryEntry.Kind.LEARNT, sentence));
  }

  private boolean isKnown(String fact) {
    Formula formula = SlParser.formula(fact, knowledge.home().vocabulary()::isFluent);
    return new Evaluation(knowledge.snapshot()).truth(formula, Map.of()) == Truth.TRUE;
  }

  /** The planner broke its search off: a better plan may exist. */
  public void notProven(Objective objective, double atLeast, Plan plan) {
    tell(
        StoryEntry.Kind.PLAN,
        objective == Objective.CHEAPEST
            ? "That this plan is the cheapest is not proven: it costs %s, none costs less than %s."
                .formatted(Sentences.number(plan.cost()), Sentences.number(atLeast))
            : "That this plan is over first is not proven: it takes %s s, none takes less than %s s."
                .formatted(Sentences.number(plan.seconds()), Sentences.number(atLeast)));
  }

  public void begun(Step step, int steps) {
    plans.begun(step);
    tell(
        StoryEntry.Kind.STEP,
        "Step " + step.number() + " of " + steps + ": " + sentences().step(step) + ".");
  }

  /**
   * The member has answered, and what it was called for is still to come.
   *
   * @param condition when it will be there; empty: after this time
   */
  public void awaitsEffect(Step step, Optional<Formula> condition, Duration atMost) {
    String seconds = Sentences.number(atMost.toMillis() / 1000.0);
    String until =
        condition
            .map(formula -> SlPrinter.print(new Substitution(step.values()).apply(formula)))
            .map(formula -> "until %s, %s s at most".formatted(formula, seconds))
            .orElse(seconds + " s");
    tell(
        StoryEntry.Kind.STEP,
        "%s has begun step %d; its effect is awaited, %s."
            .formatted(step.member(), step.number(), until));
  }

  public void askedAgain(Step step) {
    plans.begun(step);
    tell(
        StoryEntry.Kind.STEP,
        "%s is asked what became of step %d, which is no second time: %s."
            .formatted(step.member(), step.number(), sentences().step(step)));
  }

  public void done(Step step, KnowledgeBase.Change change) {
    plans.done(step);
    tell(StoryEntry.Kind.DONE, step.member() + " reports: " + news().report(change) + ".");
  }

  /** The member reports the step as done, and its own state says otherwise: why it is not done. */
  public String deniedByItself(Step step, KnowledgeBase.Change change) {
    return "%s reports %s, and its own state says otherwise: %s."
        .formatted(
            step.member(),
            step.feature().learns().isPresent() ? "what it found" : "that it is done",
            news().facts(change.denials()));
  }

  public void failed(Step step, String problem, KnowledgeBase.Change change) {
    String said = Sentences.said(step.member(), problem);
    plans.notDone(step, said);
    tell(
        StoryEntry.Kind.FAILED,
        "That failed: "
            + said
            + (change.facts().isEmpty() ? "" : " (so " + news().all(change) + ")")
            + ".");
  }

  /** From now on its member is asked only when this is so, too. */
  public void insists(Step step, List<Insistence> insisted) {
    if (!insisted.isEmpty()) {
      tell(
          StoryEntry.Kind.FAILED,
          "%s insists on more than it has described, which counts from now on: %s."
              .formatted(
                  step.member(),
                  insisted.stream()
                      .map(insistence -> sentences().fact(insistence.here()))
                      .collect(Collectors.joining(", "))));
    }
  }

  public void ends(Step step) {
    tell(
        StoryEntry.Kind.STEP,
        "%s has not said what became of it, and is told to end it: %s."
            .formatted(step.member(), sentences().step(step)));
  }

  public void cancelled(Step step) {
    plans.calledOff(step);
    tell(StoryEntry.Kind.STEP, "No longer wanted: " + sentences().step(step) + ".");
  }

  public void confirming(Confirmation needed) {
    tell(StoryEntry.Kind.CONFIRM, witnesses().wanted(needed));
  }

  /** Who saw what the goal speaks of. */
  public void confirmed(Formula goal, Map<String, Term> binding) {
    witnessed(new Substitution(binding).apply(goal));
  }

  private void witnessed(Formula goal) {
    if (goal instanceof Formula.And and) {
      and.operands().forEach(this::witnessed);
    } else if (goal instanceof Formula.Atom atom && atom.isGround()) {
      knowledge
          .snapshot()
          .belief(atom)
          .filter(belief -> belief.source().kind() == Source.Kind.OBSERVED)
          .ifPresent(
              belief ->
                  tell(
                      StoryEntry.Kind.CONFIRM,
                      belief.source().agent() + " confirms: " + sentences().fact(atom) + "."));
    }
  }

  /** Returns what is told: that it is not certain though it is said to be so. */
  public String unconfirmed(Confirmation needed) {
    String told = witnesses().missing(needed);
    tell(StoryEntry.Kind.CONFIRM, told);
    return told;
  }

  /** Its doer says that it is so, and who has looked says otherwise: a reason to give it up. */
  public String denied(Confirmation needed) {
    return witnesses().against(needed);
  }

  /** Who tells of its own accord whether it is so. */
  public void listens(String tellers, Duration pause) {
    tell(
        StoryEntry.Kind.CONFIRM,
        "Nobody can look; it is waited %d s for what %s may tell."
            .formatted(pause.toSeconds(), tellers));
  }

  void ended(GoalOutcome outcome) {
    plans.over();
    String binding =
        outcome.binding().isEmpty() ? "" : " (" + sentences().binding(outcome.binding()) + ")";
    tell(
        StoryEntry.Kind.END,
        switch (outcome.state()) {
          case ACHIEVED ->
              "Reached" + (outcome.confirmed() ? "" : ", but not seen") + binding + ".";
          case CANCELLED -> String.join(" ", outcome.reasons());
          default -> "Not reached. " + String.join(" ", outcome.reasons());
        });
  }

  public List<String> reasons(PlanningResult result) {
    if (result instanceof PlanningResult.Impossible impossible) {
      List<String> reasons =
          new ObstacleSentences(knowledge.home(), knowledge.snapshot())
              .all(impossible.explanation());
      return reasons.isEmpty() ? List.of("No agent can bring it about.") : reasons;
    }
    if (result instanceof PlanningResult.GaveUp gaveUp) {
      return List.of(gaveUp.reason());
    }
    throw new IllegalStateException("A plan that was found is no reason: " + result);
  }

  /** Tells it, and returns it as sentences. */
  public List<String> searched(SearchReport report) {
    List<String> told =
        new SearchSentences(
                new ObstacleSentences(knowledge.home(), knowledge.snapshot()), clock.now())
            .of(report);
    told.forEach(text -> tell(StoryEntry.Kind.SEARCHED, text));
    return told;
  }

  public String becauseOf(KnowledgeBase.Change change) {
    return news().all(change);
  }

  /** Why the rest is thought over after a step that was done. */
  public String becauseOf(Step step, KnowledgeBase.Change change) {
    return change.facts().isEmpty()
        ? "what %s reports is what was known before".formatted(step.member())
        : news().all(change);
  }

  /** Nothing is left to be done. */
  public String endedInVain() {
    return "all steps are done, and the goal is not reached";
  }

  public String sentence(Step step) {
    return sentences().step(step);
  }

  private NewsSentences news() {
    return new NewsSentences(knowledge.home().vocabulary());
  }

  private WitnessSentences witnesses() {
    return new WitnessSentences(knowledge.home().vocabulary(), clock.instant());
  }

  private Sentences sentences() {
    return new Sentences(knowledge.home().vocabulary());
  }

  private void tell(StoryEntry.Kind kind, String text) {
    story.tell(new StoryEntry(goalId, clock.now(), kind, text));
  }
}
