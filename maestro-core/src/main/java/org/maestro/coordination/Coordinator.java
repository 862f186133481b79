package org.maestro.coordination;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.maestro.coordination.agenda.Beginnings;
import org.maestro.coordination.allocation.ExactPrices;
import org.maestro.coordination.api.AnswerRefusal;
import org.maestro.coordination.api.ComponentWant;
import org.maestro.coordination.api.Former;
import org.maestro.coordination.api.GoalId;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalPriority;
import org.maestro.coordination.api.GoalRequest;
import org.maestro.coordination.api.GoalStatus;
import org.maestro.coordination.api.HeldNews;
import org.maestro.coordination.api.InvalidGoalException;
import org.maestro.coordination.api.JournalEntry;
import org.maestro.coordination.api.PlanRecord;
import org.maestro.coordination.api.Ports;
import org.maestro.coordination.api.Recovery;
import org.maestro.coordination.api.Respondent;
import org.maestro.coordination.api.Roster;
import org.maestro.coordination.api.ScriptStep;
import org.maestro.coordination.api.Takeover;
import org.maestro.coordination.api.WaitsFor;
import org.maestro.coordination.contention.ActiveGoal;
import org.maestro.coordination.contention.ActiveGoals;
import org.maestro.coordination.facts.FactFilter;
import org.maestro.coordination.maintenance.Wish;
import org.maestro.coordination.recovery.FormerCalls;
import org.maestro.coordination.recovery.FormerParts;
import org.maestro.coordination.recovery.JournaledDispatcher;
import org.maestro.coordination.recovery.RecoveryBarrier;
import org.maestro.coordination.scripts.ScriptGoal;
import org.maestro.coordination.story.Decision;
import org.maestro.coordination.story.Decisions;
import org.maestro.coordination.story.PlanRecords;
import org.maestro.coordination.undoing.FormerFacts;
import org.maestro.coordination.worth.Appraisals;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.knowledge.api.MemberCondition;
import org.maestro.knowledge.api.Source;
import org.maestro.ontology.home.NamedPoints;
import org.maestro.ontology.home.Script;
import org.maestro.planning.api.Step;
import org.maestro.rats.time.Clock;
import org.maestro.sl.Formula;

/**
 * Pursues the goals of one scope. Confined to one thread: the owner's, on which all ports answer
 * too.
 *
 * <p>Source: Three-layered architecture, abstract, 2, 3.2.2 and 3.3.3 (M4, M17, M21, M55, M76).
 */
public final class Coordinator {
  private final Ports ports;
  private final FormerFacts former;
  private final JournaledDispatcher dispatcher;
  private final RequestedGoals requested;
  private final Attendance attendance;
  private final Roster roster = new Roster();
  private final Appraisals appraisals;
  private final ActiveGoals activeGoals;
  private final ExactPrices exactPrices = new ExactPrices();
  private final Map<String, ActiveGoal> pursuits = new LinkedHashMap<>();
  private final EndedGoals ended = new EndedGoals();
  private final RecoveryBarrier comeback = new RecoveryBarrier();
  private final Map<String, Clock.Timer> deadlines = new HashMap<>();
  private final String prefix;
  private final BegunGoals begun = new BegunGoals();
  private int lastNumber;

  /** The coordinator of a whole platform; its goals are G1, G2 ... */
  public Coordinator(Ports ports) {
    this(ports, GoalId.CENTRAL);
  }

  /**
   * @param prefix of its goals' ids, different from that of any other coordinator of the site
   */
  public Coordinator(Ports ports, String prefix) {
    this.prefix = prefix;
    this.former = new FormerFacts(ports.knowledge());
    this.dispatcher =
        new JournaledDispatcher(
            ports.dispatcher(), ports.journal(), roster, former, ports.clock().instant());
    this.ports = ports.with(dispatcher);
    this.appraisals = new Appraisals(this.ports, this::progress, this::ranked);
    this.activeGoals =
        new ActiveGoals(ports.clock(), ports.owner(), appraisals, ports.dispatcher());
    this.requested =
        new RequestedGoals(
            this.ports,
            prefix.equals(GoalId.CENTRAL),
            roster,
            activeGoals,
            exactPrices,
            dispatcher,
            begun);
    this.attendance = new Attendance(this.ports, roster, comeback, exactPrices, activeGoals);
    if (requested.areScriptsSteps()) {
      roster.present(Script.PLANNED_AS, Optional.empty());
    }
  }

  /** Takes a goal on, of which only the end is wanted to be known. */
  public String submit(GoalRequest request, Consumer<GoalOutcome> ended) {
    return submit(request, news -> {}, ended);
  }

  /**
   * Takes a goal on.
   *
   * @param news told of a held goal each time that it begins or ceases to be so
   * @param ended told once, how it ended; a held one ends when it is cancelled
   * @return the goal's id, G1, G2 ...
   * @throws InvalidGoalException when it speaks of what nobody knows
   */
  public String submit(GoalRequest request, Consumer<HeldNews> news, Consumer<GoalOutcome> ended) {
    return submit(request, Answer.NOBODY, news, ended);
  }

  /**
   * Takes a goal on, as soon as it is written down.
   *
   * @param answer told once, that it is, or why it cannot be
   * @param news told of a held goal each time that it begins or ceases to be so
   * @param ended told once, how it ended; a held one ends when it is cancelled
   * @return the id that the goal has then, G1, G2 ...
   * @throws InvalidGoalException when it speaks of what nobody knows
   */
  public String submit(
      GoalRequest stated, Answer answer, Consumer<HeldNews> news, Consumer<GoalOutcome> ended) {
    GoalRequest request = requested.checked(stated);
    String id = begun.nextId();
    takeOn(id, request, answer, news, ended);
    return id;
  }

  /**
   * Holds a rule from now on. What it begins are goals as all are; nothing of the rule itself is
   * written down, since each coordinator is told the rules of its time.
   *
   * @param name its id among goals, and no other goal's
   * @param rule its goal is bound to a time or an event
   * @param told once, how it ended
   * @throws InvalidGoalException when it speaks of what nobody knows
   */
  public void hold(String name, GoalRequest rule, Consumer<GoalOutcome> told) {
    ActiveGoal pursuit =
        requested.rule(
            name,
            rule,
            outcome -> {
              ended(new Recovery.EndedGoal(rule, outcome));
              told.accept(outcome);
            });
    pursuits.put(name, pursuit);
    activeGoals.enter(pursuit, new GoalPriority(rule.priority(), rule.deadline(), 0));
    activeGoals.run(pursuit::start);
  }

  private void takeOn(
      String id,
      GoalRequest request,
      Answer answer,
      Consumer<HeldNews> news,
      Consumer<GoalOutcome> ended) {
    int number = GoalId.number(prefix, id);
    ports
        .journal()
        .accept(
            new JournalEntry.Submitted(id, request),
            () -> {
              ActiveGoal pursuit = pursuit(id, request, number, news, ended);
              answer.accepted(id);
              comeback.afterwards(
                  () -> ports.owner().execute(() -> activeGoals.run(pursuit::start)));
            },
            answer::refused);
  }

  /** The first answer to who states a goal. */
  public interface Answer {
    /** It may be told to nobody. */
    Answer NOBODY =
        new Answer() {
          @Override
          public void accepted(String goalId) {
            // It is heard of at its end.
          }

          @Override
          public void refused(String reason) {
            // It is not heard of again.
          }
        };

    void accepted(String goalId);

    /**
     * @param reason one sentence
     */
    void refused(String reason);
  }

  private ActiveGoal pursuit(
      String id,
      GoalRequest request,
      int number,
      Consumer<HeldNews> news,
      Consumer<GoalOutcome> told) {
    GoalPriority standing = new GoalPriority(request.priority(), request.deadline(), number);
    Consumer<GoalOutcome> over =
        outcome -> {
          Optional.ofNullable(deadlines.remove(id)).ifPresent(Clock.Timer::cancel);
          ended(new Recovery.EndedGoal(request, outcome));
          begun.ended(outcome);
          ports.journal().afterwards(() -> told.accept(outcome));
        };
    ActiveGoal pursuit =
        requested.of(
            new Wish(id, request, standing),
            heard -> ports.journal().afterwards(() -> news.accept(heard)),
            over);
    pursuits.put(id, pursuit);
    activeGoals.enter(pursuit, standing);
    if (!(request.goal() instanceof Formula.Bound)) {
      appraisals.enter(id, request, standing);
    }
    request.deadline().ifPresent(deadline -> endAt(deadline, pursuit));
    return pursuit;
  }

  /** Goals that others begin; they are this coordinator's as all are. */
  private final class BegunGoals implements Beginnings {
    private final Map<String, List<Consumer<GoalOutcome>>> followers = new HashMap<>();

    @Override
    public String nextId() {
      return GoalId.of(prefix, ++lastNumber);
    }

    @Override
    public boolean wasBegun(String goalId) {
      int number = GoalId.number(prefix, goalId);
      boolean wasBegun = number <= lastNumber;
      lastNumber = Math.max(lastNumber, number);
      return wasBegun;
    }

    @Override
    public void begin(
        String goalId, GoalRequest request, Runnable accepted, Consumer<String> refused) {
      try {
        takeOn(
            goalId,
            requested.checked(request),
            answer(accepted, refused),
            news -> {},
            outcome -> {});
      } catch (InvalidGoalException e) {
        refused.accept(String.valueOf(e.getMessage()));
      }
    }

    private Answer answer(Runnable accepted, Consumer<String> refused) {
      return new Answer() {
        @Override
        public void accepted(String goalId) {
          accepted.run();
        }

        @Override
        public void refused(String reason) {
          activeGoals.run(() -> refused.accept(reason));
        }
      };
    }

    @Override
    public boolean follow(String goalId, Consumer<GoalOutcome> ended) {
      Optional<Recovery.EndedGoal> over = Coordinator.this.ended.find(goalId);
      over.ifPresentOrElse(
          goal -> ended.accept(goal.outcome()),
          () -> followers.computeIfAbsent(goalId, id -> new ArrayList<>()).add(ended));
      return over.isPresent() || pursuits.containsKey(goalId);
    }

    private void ended(GoalOutcome outcome) {
      Optional.ofNullable(followers.remove(outcome.id()))
          .orElse(List.of())
          .forEach(follower -> follower.accept(outcome));
    }

    @Override
    public boolean isHolding(String goalId) {
      return progress(goalId).filter(ActiveGoal::isHolding).isPresent();
    }

    @Override
    public void cancel(String goalId, String who) {
      Coordinator.this.cancel(goalId, who);
    }
  }

  /** A goal, or one that is pursued for a part of a script. */
  private Optional<ActiveGoal> underway(String goalId) {
    return activeGoals.find(goalId).or(() -> Optional.ofNullable(pursuits.get(goalId)));
  }

  /** Of what is over little is kept: a platform pursues goals for as long as it runs. */
  private void ended(Recovery.EndedGoal goal) {
    String id = goal.outcome().id();
    ended.put(goal);
    dispatcher.over(id);
    ActiveGoal over = pursuits.remove(id);
    ports.knowledge().dismiss(NamedPoints.of(goal.request().goal()));
    appraisals.ended(goal.request(), goal.outcome());
    ended.keep(id, over);
  }

  private Optional<ActiveGoal> progress(String id) {
    return Optional.ofNullable(pursuits.get(id));
  }

  private void ranked(String id, GoalPriority standing) {
    activeGoals.rank(id, standing);
  }

  /** The same, and of held goals only the end is wanted to be known. */
  public void resume(Recovery recovery, Duration patience, Consumer<GoalOutcome> told) {
    resume(recovery, patience, news -> {}, told);
  }

  /**
   * Goes on with what coordinators before this one have left. To be called before anything else.
   * Nothing begins before the members are back that were there then, or that time has passed.
   *
   * @param patience simulated time for members to show up again
   * @param news told of each held goal among them each time that it begins or ceases to be so
   * @param told once of each goal that had no end yet, how it ended
   */
  public void resume(
      Recovery recovery, Duration patience, Consumer<HeldNews> news, Consumer<GoalOutcome> told) {
    lastNumber = Math.max(lastNumber, recovery.lastGoalNumber());
    for (Recovery.EndedGoal goal : recovery.ended()) {
      ended.put(goal);
      appraisals.ended(goal.request(), goal.outcome());
    }
    if (recovery.goals().isEmpty() && recovery.unwanted().isEmpty()) {
      return;
    }
    recovery.members().stream().filter(m -> !roster.isPresent(m)).forEach(comeback::await);
    for (Recovery.UnfinishedGoal goal : recovery.goals()) {
      pursuit(goal.id(), goal.request(), GoalId.number(prefix, goal.id()), news, told)
          .prepareToTakeUp(goal, "for its devices to come back after the restart");
    }
    FormerCalls former = new FormerCalls(requested.ports(), roster);
    comeback.afterwards(() -> activeGoals.run(() -> takeUp(recovery, former)));
    Clock clock = ports.clock();
    clock.schedule(patience, "comeback", () -> ports.owner().execute(comeback::giveUp));
  }

  /** Goals with something under way go first: what their steps use is theirs. */
  private void takeUp(Recovery recovery, FormerCalls former) {
    FormerParts parts = new FormerParts(recovery, former);
    requested.takeUp(parts);
    recovery.unwanted().forEach(call -> former.giveUp(call, "nobody wants it"));
    recovery.goals().stream()
        .sorted(Comparator.comparing(goal -> !goal.hasCalls()))
        .forEach(
            goal ->
                Optional.ofNullable(pursuits.get(goal.id()))
                    .ifPresent(pursuit -> pursuit.takeUp(goal, former)));
    recovery.goals().stream()
        .filter(goal -> requested.script(goal.request()).isEmpty())
        .forEach(
            goal -> parts.giveUpOthers(goal.id(), "the plan of which it was a part is made anew"));
  }

  /** The clock's thread only hands over. */
  private void endAt(Duration deadline, ActiveGoal pursuit) {
    Clock clock = ports.clock();
    Clock.Timer timer =
        clock.schedule(
            deadline.minus(clock.now()),
            pursuit.id(),
            () -> ports.owner().execute(() -> activeGoals.run(pursuit::deadlinePassed)));
    deadlines.put(pursuit.id(), timer);
  }

  /** Returns whether there is such a goal, and it had not ended yet. */
  public boolean cancel(String goalId, String who) {
    ActiveGoal pursuit = pursuits.get(goalId);
    if (pursuit == null) {
      return false;
    }
    activeGoals.run(() -> pursuit.cancel(who));
    return true;
  }

  /**
   * Tells what was so before the goal, once that is over and nothing that was begun for it is under
   * way.
   *
   * @param others what is wanted then: of what these speak nothing is to be as it was
   */
  public void beforeGoal(String goalId, Supplier<List<Formula>> others, Consumer<Former> told) {
    if (pursuits.containsKey(goalId)) {
      begun.follow(goalId, outcome -> beforeGoal(goalId, others, told));
      return;
    }
    former.whenAtRest(
        goalId,
        () ->
            told.accept(
                ended
                    .find(goalId)
                    .map(goal -> former.before(goalId, goal.request().goal(), others.get()))
                    .orElse(Former.NOTHING)));
  }

  /**
   * Takes an answer to a question that a script has asked. One that is not what was asked for
   * leaves the question open.
   *
   * @param part of the script that asked, such as G7.2
   * @param by of whom the story tells
   * @param then told once: nothing when it was taken and would survive the end of the process, or
   *     else why it was not
   */
  public void answer(
      String part, String text, Respondent by, Consumer<Optional<AnswerRefusal>> then) {
    Consumer<Optional<AnswerRefusal>> told =
        refusal -> {
          if (refusal.isEmpty()) {
            ports.journal().afterwards(() -> then.accept(refusal));
          } else {
            then.accept(refusal);
          }
        };
    activeGoals.run(
        () ->
            asking(part)
                .ifPresentOrElse(
                    script -> script.answer(part, text, by, told),
                    () -> told.accept(Optional.of(AnswerRefusal.notOpen(part)))));
  }

  /** The script nearest to the part; a step of a plan may be one as well. */
  private Optional<ScriptGoal> asking(String part) {
    Optional<String> whole = Optional.of(part);
    while (whole.isPresent()) {
      whole = whole.flatMap(GoalId::enclosing);
      Optional<ScriptGoal> script =
          whole
              .flatMap(this::underway)
              .filter(ScriptGoal.class::isInstance)
              .map(ScriptGoal.class::cast);
      if (script.isPresent()) {
        return script;
      }
    }
    return Optional.empty();
  }

  public void memberPresent(String member) {
    memberPresent(member, Optional.empty());
  }

  /**
   * The member can be used.
   *
   * @param life names the life that it lives, and the way in which it is called: calls of another
   *     life are unknown to it
   */
  public void memberPresent(String member, Optional<String> life) {
    attendance.present(member, life);
  }

  /**
   * The member may be gone: nothing is asked of it, and no goal is given up for want of it, until
   * it is there again or lost.
   */
  public void memberDoubted(String member, String reason) {
    attendance.doubted(member, reason);
  }

  /** The member has never been there, and this is why. */
  public void memberAway(String member, String reason) {
    attendance.away(member, reason);
  }

  /** The member was there all the time. */
  public void memberTrusted(String member) {
    attendance.trusted(member);
  }

  /**
   * The member is gone: what it knew of itself is forgotten, and plans that count on it are made
   * anew.
   */
  public void memberLost(String member, String reason) {
    attendance.lost(member, reason);
  }

  /**
   * A member offers to take over a running step of the goal; nothing is promised to it
   * (Three-layered architecture, 3.2.1; M43).
   */
  public void offered(String goalId, Takeover offer) {
    activeGoals.run(() -> underway(goalId).ifPresent(p -> p.offered(offer)));
  }

  /** The member says that it is at a step of the goal still, though it takes long. */
  public void alive(String goalId, String member, String feature) {
    dispatcher.alive(goalId, member, feature);
  }

  /**
   * A member gives back a running step of the goal, and brings itself to a safe state
   * (Three-layered architecture, 3.2.1; M44).
   */
  public void givenBack(String goalId, String member, String feature, String reason) {
    activeGoals.run(
        () -> underway(goalId).ifPresent(pursuit -> pursuit.givenBack(member, feature, reason)));
  }

  /** A goal of another manager wants parts of a member that goals of this one may have. */
  public void wantedElsewhere(ComponentWant want) {
    activeGoals.otherManagers().want(want);
  }

  /** That goal wants nothing of the member any more. */
  public void wantedNoMore(String goalId, String member) {
    activeGoals.otherManagers().wantNoMore(goalId, member);
  }

  /** Another manager has given these parts of the member back, for goals of this one. */
  public void gotComponents(String member, Set<String> components) {
    activeGoals.otherManagers().gave(member, components);
  }

  public void knowledgeChanged(KnowledgeBase.Change change) {
    if (!MemberCondition.isAllOf(change.facts())) {
      exactPrices.forget(change.source().agent());
    }
    if (isOfADevice(change.source())) {
      roster.described(change.source().agent(), ports.clock().now());
    }
    if (activeGoals.all().isEmpty()) {
      return;
    }
    FactFilter changed = FactFilter.of(change.facts(), ports.knowledge().home().vocabulary());
    activeGoals.run(
        () -> activeGoals.all().forEach(pursuit -> pursuit.knowledgeChanged(change, changed)));
    appraisals.knowledgeChanged(changed);
  }

  /** Whether a goal is not over; any thread may ask. */
  public boolean isAtWork() {
    return activeGoals.isAny();
  }

  private boolean isOfADevice(Source source) {
    return source.kind() == Source.Kind.DESCRIBED
        && ports.knowledge().home().devices().containsKey(source.agent());
  }

  /** Whether a goal of that id is or was pursued. */
  public boolean hasGoal(String goalId) {
    return pursuits.containsKey(goalId) || ended.find(goalId).isPresent();
  }

  /** Whether a goal of that id was pursued, and has ended. */
  public boolean isOver(String goalId) {
    return ended.find(goalId).isPresent();
  }

  /** Whether there was a goal of that id; nothing more may be known of it. */
  public boolean hasHad(String goalId) {
    int number = GoalId.number(prefix, goalId);
    return number > 0 && number <= lastNumber;
  }

  /**
   * Why a step of one of the goal's latest plans was given to its member: planned again without it,
   * beside this thread.
   *
   * @param plan its number in the story; empty: the latest that was made to bring the goal about
   * @param step its number
   * @param told the choice in sentences; one that says so when there is no such step
   */
  public void explainChoice(
      String goalId, OptionalInt plan, int step, Consumer<List<String>> told) {
    Decisions decisions =
        Optional.ofNullable(pursuits.get(goalId))
            .map(ActiveGoal::decisions)
            .or(() -> ended.decisions(goalId))
            .orElseGet(Decisions::new);
    Optional<Decision> decision = decisions.find(plan);
    Optional<Step> chosen = decision.flatMap(d -> d.step(step));
    if (chosen.isEmpty()) {
      told.accept(List.of(decisions.whyNot(goalId, plan, step)));
      return;
    }
    ports
        .thinking()
        .patient()
        .think(
            () ->
                decision
                    .get()
                    .sentences(
                        decision.get().choice(ports.planner(), chosen.get()),
                        ports.knowledge().home()),
            told);
  }

  /**
   * The goal's latest plans, oldest first, and what has become of their steps; of a goal that is
   * held those that were made lately to bring it about. None where none is kept.
   */
  public List<PlanRecord> plans(String goalId) {
    return planned(goalId).map(PlanRecords::all).orElse(List.of());
  }

  /** The steps of the script that the goal is, and what has become of them; else none. */
  public List<ScriptStep> stepsOfScript(String goalId) {
    return planned(goalId).map(PlanRecords::ofScript).orElse(List.of());
  }

  private Optional<PlanRecords> planned(String goalId) {
    return Optional.ofNullable(pursuits.get(goalId))
        .map(ActiveGoal::plans)
        .or(() -> ended.plans(goalId));
  }

  public boolean isPresent(String member) {
    return roster.isPresent(member);
  }

  /** Whether the member may be there, and is not counted on until that is certain. */
  public boolean isDoubted(String member) {
    return roster.doubts().containsKey(member);
  }

  public List<GoalStatus> goals() {
    List<GoalStatus> goals = new ArrayList<>(ended.statuses(ports.clock().now()));
    pursuits.values().forEach(pursuit -> goals.add(pursuit.status()));
    goals.sort(Comparator.comparingInt(goal -> GoalId.number(prefix, goal.id())));
    return goals;
  }

  /** Who asked for a goal, also when it is over: steps may have yet to come to rest. */
  public Optional<String> requester(String goalId) {
    String whole = GoalId.whole(goalId);
    return Optional.ofNullable(pursuits.get(whole))
        .map(goal -> goal.status().requester())
        .or(() -> ended.find(whole).map(goal -> goal.request().requester()));
  }

  /** The highest number that a goal's id has had. */
  public int lastGoalNumber() {
    return lastNumber;
  }

  /** The wait-for graph: which goal waits for what, and which goal has it. */
  public List<WaitsFor> waits() {
    return activeGoals.leases().graph();
  }
}
