package org.maestro.coordination;

import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import org.maestro.coordination.achievement.AchievementGoal;
import org.maestro.coordination.agenda.Beginnings;
import org.maestro.coordination.agenda.EntryGoal;
import org.maestro.coordination.allocation.ExactPrices;
import org.maestro.coordination.api.GoalCheck;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalRequest;
import org.maestro.coordination.api.HeldNews;
import org.maestro.coordination.api.InvalidGoalException;
import org.maestro.coordination.api.Journal;
import org.maestro.coordination.api.Ports;
import org.maestro.coordination.api.Roster;
import org.maestro.coordination.api.Story;
import org.maestro.coordination.composites.CompositeActions;
import org.maestro.coordination.contention.ActiveGoal;
import org.maestro.coordination.contention.ActiveGoals;
import org.maestro.coordination.lessons.VainDeeds;
import org.maestro.coordination.limits.GoalsOfPersons;
import org.maestro.coordination.limits.RefusedGoal;
import org.maestro.coordination.maintenance.MaintenanceGoal;
import org.maestro.coordination.maintenance.Reaching;
import org.maestro.coordination.maintenance.Wish;
import org.maestro.coordination.recovery.FormerParts;
import org.maestro.coordination.recovery.JournaledDispatcher;
import org.maestro.coordination.scripts.ScriptGoal;
import org.maestro.coordination.scripts.Subgoals;
import org.maestro.ontology.home.NamedPoints;
import org.maestro.ontology.home.PrivateWords;
import org.maestro.ontology.home.Script;
import org.maestro.sl.Formula;

/**
 * The goals that requests are: one to achieve, one to hold, one that begins at a time or by an
 * event, a script, or one that may not be pursued for whom it is asked. Each is limited by who asks
 * for it, and keeps private words to itself. The coordinator's thread only.
 */
final class RequestedGoals {
  private final Ports ports;
  private final boolean isCentral;
  private final Roster roster;
  private final ActiveGoals activeGoals;
  private final ExactPrices exactPrices;
  private final Beginnings begun;
  private final Subgoals parts;
  private final ScriptsInPlans runs;
  private final CompositeActions composites;
  private final GoalsOfPersons persons;

  /**
   * @param isCentral only the central coordinator has all devices that a script may use
   */
  RequestedGoals(
      Ports ports,
      boolean isCentral,
      Roster roster,
      ActiveGoals activeGoals,
      ExactPrices exactPrices,
      JournaledDispatcher dispatcher,
      Beginnings begun) {
    this.ports = ports;
    this.isCentral = isCentral;
    this.roster = roster;
    this.activeGoals = activeGoals;
    this.exactPrices = exactPrices;
    this.begun = begun;
    this.parts = new PartsOfScripts(roster, activeGoals, exactPrices, dispatcher);
    this.runs = new ScriptsInPlans(ports, activeGoals, parts);
    this.composites = new CompositeActions(ports, runs);
    this.persons = new GoalsOfPersons(ports);
  }

  /**
   * What is asked for, with what it is worth.
   *
   * @throws InvalidGoalException when it speaks of what nobody knows
   */
  GoalRequest checked(GoalRequest stated) {
    GoalRequest request = ScriptGoal.weighed(stated, ports.knowledge().home().scripts());
    new GoalCheck(ports.knowledge().home()).check(request);
    return request;
  }

  /**
   * One that begins others; nothing of it is written down.
   *
   * @throws InvalidGoalException when it speaks of what nobody knows
   */
  ActiveGoal rule(String name, GoalRequest rule, Consumer<GoalOutcome> over) {
    new GoalCheck(ports.knowledge().home()).check(rule);
    ports.knowledge().admit(NamedPoints.of(rule.goal()));
    Ports unwritten = keeping(privateWords(rule), ports.with(Journal.none()));
    return new EntryGoal(name, rule, unwritten, activeGoals, begun, over);
  }

  ActiveGoal of(Wish wish, Consumer<HeldNews> news, Consumer<GoalOutcome> over) {
    String id = wish.id();
    GoalRequest request = wish.request();
    ports.knowledge().admit(NamedPoints.of(request.goal()));
    Set<String> kept = privateWords(request);
    Ports open = keeping(kept, ports);
    Optional<String> objection = persons.objection(request);
    if (objection.isPresent()) {
      return new RefusedGoal(id, request, objection.get(), open, activeGoals, over);
    }
    Ports own = persons.world(request, open.story());
    CompositeActions steps = composites(own);
    Optional<Script> script = script(request);
    if (script.isPresent()) {
      Ports within = keeping(kept, areScriptsSteps() ? steps.within(script.get()) : own);
      return new ScriptGoal(
          id, request, script.get(), wish.standing(), within, activeGoals, parts, over);
    }
    if (request.goal() instanceof Formula.Bound) {
      return new EntryGoal(id, request, open, activeGoals, begun, over);
    }
    Ports world = keeping(kept, areScriptsSteps() ? steps.ports() : own);
    VainDeeds deeds = new VainDeeds();
    Reaching reaching =
        (asked, with, then) ->
            new AchievementGoal(id, asked, with, roster, activeGoals, exactPrices, deeds, then);
    return request.goal() instanceof Formula.Keep
        ? new MaintenanceGoal(wish, world, activeGoals, exactPrices, reaching, news, over)
        : reaching.pursuit(request, world, over);
  }

  /** The script that is asked for by its name. */
  Optional<Script> script(GoalRequest request) {
    return ScriptGoal.script(request.goal(), ports.knowledge().home().scripts());
  }

  /** Whether plans may have scripts as their steps. */
  boolean areScriptsSteps() {
    return isCentral && composites.isAny();
  }

  /** By which steps are called, scripts among them. */
  Ports ports() {
    return areScriptsSteps() ? composites.ports() : ports;
  }

  /** From now on what scripts had under way before a restart is known. */
  void takeUp(FormerParts former) {
    runs.takeUp(former);
  }

  /** Scripts in plans, whose steps are limited as the goal is that has them. */
  private CompositeActions composites(Ports own) {
    return own.equals(ports) ? composites : new CompositeActions(own, runs);
  }

  private Set<String> privateWords(GoalRequest request) {
    PrivateWords words = PrivateWords.of(ports.knowledge().home());
    return request
        .stakes()
        .map(stakes -> words.usedFor(request.goal(), stakes.benefit()))
        .orElseGet(() -> words.usedFor(request.goal()));
  }

  /** What is told of a goal that uses private words is not for everybody. */
  private static Ports keeping(Set<String> words, Ports world) {
    return words.isEmpty()
        ? world
        : world.with((Story) entry -> world.story().tell(entry.using(words)));
  }
}
