package org.maestro.coordination;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import org.maestro.knowledge.KnowledgeBase;
import org.maestro.knowledge.Snapshot;
import org.maestro.rats.time.Clock;
import org.maestro.sl.Change;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Formula;
import org.maestro.sl.FreeVariables;
import org.maestro.sl.Truth;
import org.maestro.sl.TypedVariable;

/**
 * A goal that is held until it is cancelled: brought about, observed without a break, restored when
 * it is lost, and held by cheaper settings when these would do (M5, M91). Bringing about and
 * setting anew are pursuits of their own that end, so that the goal keeps nothing from others while
 * it holds. The coordinator's thread only.
 */
final class HeldPursuit implements Pursuit {
  /** Cheaper settings are looked for so often at most. */
  private static final Duration BETWEEN_SETTINGS = Duration.ofSeconds(60);

  /** Facts grow too old without news; so often it is looked at in any case. */
  private static final Duration BETWEEN_LOOKS = Duration.ofSeconds(60);

  /** What is wished for, and where that stands among the wishes of others. */
  record Wish(String id, GoalRequest request, Standing standing) {}

  /** Begins a goal that is to be reached once. */
  interface Reaching {
    Pursuit pursuit(GoalRequest request, Ports ports, Consumer<GoalOutcome> ended);
  }

  private final Wish wish;
  private final Formula condition;
  private final Formula closed;
  private final Ports ports;
  private final Ports working;
  private final Rivals rivals;
  private final Reaching reaching;
  private final GoalLife life;
  private final HeldStory story;
  private final Watch watch;
  private final OwnSettings settings = new OwnSettings();
  private final Economy economy;
  private final Patience patience = new Patience();
  private final Consumer<HeldNews> news;

  private Optional<Pursuit> work = Optional.empty();
  private Clock.Timer timer = () -> {};
  private Duration lastSetting = Duration.ZERO;
  private boolean setting;
  private boolean considering;
  private boolean holding;
  private boolean everHeld;
  private boolean started;
  private boolean unobserved;
  private Optional<String> suspendedFor = Optional.empty();
  private String lastReasons = "";

  HeldPursuit(
      Wish wish,
      Ports ports,
      Rivals rivals,
      ExactPrices exactPrices,
      Reaching reaching,
      Consumer<HeldNews> news,
      Consumer<GoalOutcome> ended) {
    this.wish = wish;
    this.rivals = rivals;
    this.condition = ((Formula.Keep) wish.request().goal()).body();
    this.closed = closed(condition);
    this.ports = ports;
    this.reaching = reaching;
    this.news = news;
    this.watch = new Watch(condition);
    this.story = new HeldStory(wish.id(), ports);
    this.life = new GoalLife(wish.id(), wish.request(), ports, story.goal(), ended);
    KnowledgeBase seen =
        new WatchedKnowledge(
            ports.knowledge(), now -> unobserved ? now : watch.seen(now, ports.knowledge().home()));
    this.working =
        new Ports(
            seen,
            ports.planner(),
            ports.market(),
            new HeldCrew(ports.crew(), ports.knowledge(), watch, settings),
            ports.thinking(),
            ports.clock(),
            story::tellOfWork);
    this.economy = new Economy(wish.id(), condition, working, exactPrices, settings);
  }

  /** The condition for any values of its free variables. */
  private static Formula closed(Formula condition) {
    List<TypedVariable> free =
        FreeVariables.of(condition).stream()
            .map(name -> new TypedVariable(name, Optional.empty()))
            .toList();
    return free.isEmpty() ? condition : new Formula.Exists(free, condition);
  }

  @Override
  public void start() {
    started = true;
    story.goal().submitted(life.request());
    lookAgainIn(BETWEEN_LOOKS);
    bringAbout();
  }

  @Override
  public void prepareToTakeUp(Recovery.UnfinishedGoal goal, String awaited) {
    life.takeUp(goal);
    life.become(GoalState.WAITING, awaited);
    everHeld = goal.state() == GoalState.HOLDING;
    begin(once(condition), working, this::broughtAbout);
    work.ifPresent(pursuit -> pursuit.prepareToTakeUp(goal, awaited));
  }

  @Override
  public void takeUp(Recovery.UnfinishedGoal goal, FormerCalls former) {
    started = true;
    lookAgainIn(BETWEEN_LOOKS);
    work.ifPresent(pursuit -> pursuit.takeUp(goal, former));
  }

  @Override
  public String id() {
    return wish.id();
  }

  @Override
  public int priority() {
    return wish.request().priority();
  }

  @Override
  public GoalStatus status() {
    GoalStatus own = life.status(rivals.leases().waitsOf(id()));
    return work.filter(w -> !setting && !own.state().isFinal())
        .map(Pursuit::status)
        .map(now -> own.as(now.state(), now.detail()))
        .orElse(own);
  }

  @Override
  public void cancel(String who) {
    if (!life.isOver()) {
      end(GoalState.CANCELLED, "Cancelled by " + who + ".");
    }
  }

  @Override
  public void deadlinePassed() {
    if (!life.isOver() && !everHeld) {
      end(GoalState.FAILED, "Its deadline has passed" + life.standingInWords() + ".");
    }
  }

  @Override
  public void knowledgeChanged(KnowledgeBase.Change change, Interest changed) {
    work.ifPresent(pursuit -> pursuit.knowledgeChanged(change, changed));
    look();
  }

  @Override
  public void memberPresent(String member) {
    unobserved = false;
    patience.renewed(now());
    look();
  }

  @Override
  public Optional<Decision> decision() {
    return work.flatMap(Pursuit::decision);
  }

  @Override
  public void memberLost(String member) {
    watch.memberLost(member);
    patience.renewed(now());
    work.ifPresent(pursuit -> pursuit.memberLost(member));
    look();
  }

  @Override
  public void advance() {
    work.ifPresentOrElse(Pursuit::advance, this::look);
  }

  @Override
  public StepsUnderway underway() {
    return work.map(Pursuit::underway).orElseGet(StepsUnderway::new);
  }

  @Override
  public boolean isHolding() {
    return holding && (work.isEmpty() || setting);
  }

  @Override
  public Optional<Formula> countsOn(List<Change> changes, Snapshot now, String other) {
    Optional<Formula> ofWork = work.flatMap(pursuit -> pursuit.countsOn(changes, now, other));
    if (ofWork.isPresent() || !isHolding() || suspendedFor.isPresent()) {
      return ofWork;
    }
    Reliance reliance = new Reliance(ports.knowledge().home().vocabulary());
    reliance.addAll(closed, Map.of());
    return reliance.brokenBy(changes, now);
  }

  @Override
  public boolean isTied(String member) {
    return work.filter(pursuit -> pursuit.isTied(member)).isPresent();
  }

  @Override
  public double remainingSeconds() {
    return work.map(Pursuit::remainingSeconds).orElse(0.0);
  }

  @Override
  public double secondsOfRunningSteps() {
    return work.map(Pursuit::secondsOfRunningSteps).orElse(0.0);
  }

  @Override
  public void giveWayTo(String other) {
    work.ifPresent(pursuit -> pursuit.giveWayTo(other));
  }

  @Override
  public void stepBackFor(String other) {
    work.ifPresent(pursuit -> pursuit.stepBackFor(other));
  }

  /** Asked for only while it holds. */
  @Override
  public void standBackFor(String other) {
    stopWork();
    suspendedFor = Optional.of(other);
    String why = other + " goes first";
    rivals
        .leases()
        .waitFor(id(), Set.of(), List.of(new WaitsFor(id(), Resource.endOf(other), other)));
    become(GoalState.SUSPENDED, why);
    story.goal().suspended(why);
  }

  /** Whether it rests for another that is not over. */
  private boolean rests() {
    if (suspendedFor.isEmpty()) {
      return false;
    }
    if (suspendedFor.flatMap(rivals::find).isPresent()) {
      if (!isSo(working.knowledge())) {
        noteLoss();
      }
      return true;
    }
    suspendedFor = Optional.empty();
    rivals.leases().stopWaiting(id());
    story.goal().goesOn();
    return false;
  }

  /** Is it so, and does it have to be done something about it? */
  private void look() {
    if (!started || life.isOver() || work.isPresent() && !setting || rests()) {
      return;
    }
    if (isSo(working.knowledge())) {
      if (work.isEmpty()) {
        holds();
        saveIfDue();
      }
    } else {
      stopWork();
      loses();
    }
  }

  private boolean isSo(KnowledgeBase knowledge) {
    return new Evaluation(knowledge.snapshot()).truth(closed, Map.of()) == Truth.TRUE;
  }

  private void stopWork() {
    Optional<Pursuit> stopped = work;
    work = Optional.empty();
    setting = false;
    if (stopped.isPresent()) {
      stopped.get().cancel(id());
      rivals.enter(this, wish.standing());
    }
  }

  /** It is not so by what is observed now; perhaps it only lacks an observer. */
  private void loses() {
    noteLoss();
    Duration pause = patience.left(now());
    if (pause.isZero()) {
      bringAbout();
    } else {
      become(GoalState.WAITING, lastReasons.isEmpty() ? "it is tried again soon" : lastReasons);
      lookAgainIn(pause);
    }
  }

  private void noteLoss() {
    if (holding && !isSo(ports.knowledge())) {
      holding = false;
      patience.lost(now());
      story.lost(closed);
      tell(HeldNews.Kind.LOST, List.of());
    }
  }

  private void bringAbout() {
    story.begin(!lastReasons.isEmpty());
    begin(once(condition), working, this::broughtAbout);
    work.ifPresent(Pursuit::start);
  }

  private GoalRequest once(Formula goal) {
    return new GoalRequest(goal, wish.request().requester(), priority(), Optional.empty());
  }

  private void begin(GoalRequest request, Ports with, Consumer<GoalOutcome> then) {
    Pursuit[] begun = new Pursuit[1];
    begun[0] =
        reaching.pursuit(
            request, with, outcome -> rivals.run(() -> workEnded(begun[0], outcome, then)));
    work = Optional.of(begun[0]);
  }

  private void workEnded(Pursuit ended, GoalOutcome outcome, Consumer<GoalOutcome> then) {
    if (!life.isOver() && work.filter(current -> current == ended).isPresent()) {
      work = Optional.empty();
      rivals.enter(this, wish.standing());
      then.accept(outcome);
    }
  }

  private void broughtAbout(GoalOutcome outcome) {
    if (outcome.reached() && isSo(working.knowledge())) {
      lastSetting = now();
      holds();
    } else if (!unobserved && !outcome.reached()) {
      // Perhaps nobody can observe it all the time; then what is known has to do.
      unobserved = true;
      bringAbout();
    } else {
      failed(
          outcome.reached()
              ? List.of("What was done for it has not made it so.")
              : outcome.reasons());
    }
  }

  private void failed(List<String> reasons) {
    unobserved = false;
    patience.failed(now());
    String text = String.join(" ", reasons);
    if (!text.equals(lastReasons)) {
      lastReasons = text;
      story.cannotBeHeld(reasons);
      tell(HeldNews.Kind.LOST, reasons);
    }
    become(GoalState.WAITING, text);
    lookAgainIn(patience.left(now()));
  }

  private void holds() {
    if (!holding) {
      holding = true;
      patience.held(now());
      lastReasons = "";
      story.holds(closed, everHeld, unobserved);
      tell(everHeld ? HeldNews.Kind.HELD_AGAIN : HeldNews.Kind.HELD, List.of());
      everHeld = true;
    }
    become(GoalState.HOLDING, unobserved ? "nobody can observe it all the time" : "");
  }

  private void saveIfDue() {
    settings.compare(ports.knowledge().snapshot());
    if (considering || settings.isEmpty()) {
      return;
    }
    Duration wait = lastSetting.plus(BETWEEN_SETTINGS).minus(now());
    if (wait.compareTo(Duration.ZERO) > 0) {
      return;
    }
    considering = true;
    lastSetting = now();
    economy.consider(
        cheaper ->
            rivals.run(
                () -> {
                  considering = false;
                  if (suspendedFor.isEmpty() && holding && work.isEmpty() && !life.isOver()) {
                    cheaper.ifPresent(this::setAnew);
                  }
                }));
  }

  private void setAnew(Economy.Cheaper cheaper) {
    story.cheaper(cheaper);
    setting = true;
    begin(
        once(cheaper.goal()),
        new Ports(
            working.knowledge(),
            new HoldingOrder(working.planner(), closed),
            working.market(),
            working.crew(),
            working.thinking(),
            working.clock(),
            working.story()),
        outcome -> {
          setting = false;
          lastSetting = now();
          look();
        });
    work.ifPresent(Pursuit::start);
  }

  private void end(GoalState how, String reason) {
    timer.cancel();
    stopWork();
    watch.end();
    life.end(how, false, Map.of(), List.of(reason));
    rivals.leave(id());
  }

  private void become(GoalState next, String why) {
    if (life.state() != next || !life.detail().equals(why)) {
      life.become(next, why);
    }
  }

  private void tell(HeldNews.Kind kind, List<String> reasons) {
    news.accept(new HeldNews(id(), kind, reasons));
  }

  /** The next look that nothing else may bring about; an earlier one replaces a later one. */
  private void lookAgainIn(Duration wait) {
    timer.cancel();
    timer =
        ports
            .clock()
            .schedule(
                wait,
                id(),
                () -> ports.thinking().think(this::id, due -> rivals.run(this::lookAnyway)));
  }

  private void lookAnyway() {
    if (!life.isOver()) {
      lookAgainIn(BETWEEN_LOOKS);
      look();
    }
  }

  private Duration now() {
    return ports.clock().now();
  }
}
