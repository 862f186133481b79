package org.maestro.coordination.contention;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.maestro.coordination.api.GoalRequest;
import org.maestro.coordination.api.JournalEntry;
import org.maestro.coordination.api.Ports;
import org.maestro.coordination.api.Resource;
import org.maestro.coordination.api.Sentences;
import org.maestro.coordination.api.WaitsFor;
import org.maestro.coordination.facts.CausalLinks;
import org.maestro.coordination.facts.FactFilter;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.ontology.vocabulary.Claim;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.planning.api.Step;
import org.maestro.sl.Change;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/**
 * One goal among others: what it needs, has, holds in its hands and counts on.
 *
 * <p>All components that the present part of the plan uses are kept at once or not at all, from the
 * first step that uses them until no step that is left uses them or builds on what they did. What a
 * member carries for the goal ties the member to it.
 */
public final class ResourceClaims {
  private final String goalId;
  private final GoalRequest request;
  private final Ports ports;
  private final ActiveGoals activeGoals;
  private final PlanUnderway plan;
  private final StepsUnderway underway;
  private final Set<Formula.Atom> carried = new LinkedHashSet<>();
  private Optional<FactFilter> broughtAbout = Optional.empty();
  private JournalEntry.Keeps written;

  public ResourceClaims(
      String goalId,
      GoalRequest request,
      Ports ports,
      ActiveGoals activeGoals,
      PlanUnderway plan,
      StepsUnderway underway) {
    this.goalId = goalId;
    this.request = request;
    this.ports = ports;
    this.activeGoals = activeGoals;
    this.plan = plan;
    this.underway = underway;
    this.written = JournalEntry.Keeps.nothing(goalId);
  }

  /** What it had before this coordinator was there. */
  public void takeUp(JournalEntry.Keeps former) {
    written = former;
    leases().keep(goalId, former.components());
    carried.addAll(former.carried());
    if (!former.broughtAbout().isEmpty()) {
      broughtAbout = Optional.of(FactFilter.of(former.broughtAbout(), vocabulary()));
    }
  }

  private void writeDown() {
    JournalEntry.Keeps now =
        new JournalEntry.Keeps(
            goalId,
            leases().kept(goalId),
            Set.copyOf(carried),
            broughtAbout.map(FactFilter::subjects).orElse(Map.of()));
    if (!now.equals(written)) {
      written = now;
      ports.journal().write(now);
    }
  }

  private Leases leases() {
    return activeGoals.leases();
  }

  private Vocabulary vocabulary() {
    return ports.knowledge().home().vocabulary();
  }

  static Set<Resource> components(Step step) {
    Set<Resource> components = new TreeSet<>();
    step.feature().occupies().forEach(c -> components.add(Resource.component(step.member(), c)));
    return components;
  }

  static Set<Resource> components(Collection<Step> steps) {
    Set<Resource> components = new TreeSet<>();
    steps.forEach(step -> components.addAll(components(step)));
    return components;
  }

  /** What the step has for itself while it runs. */
  Set<Resource> uses(Step step) {
    Set<Resource> used = components(step);
    Evaluation evaluation = new Evaluation(ports.knowledge().snapshot());
    for (Claim claim : step.feature().claims()) {
      Map<String, Term> bindings = step.values();
      for (Term.Name name :
          ports.knowledge().snapshot().individuals(claim.variable().className().orElse(""))) {
        bindings.put(claim.variable().name(), name);
        if (evaluation.truth(claim.when(), bindings) == Truth.TRUE) {
          used.add(Resource.individual(name.text()));
        }
      }
    }
    return used;
  }

  /** What the present part of the plan needs kept. */
  public Set<Resource> wanted() {
    return components(plan.presentPart());
  }

  /** Keeps all that is wanted, or tells what stands in the way. */
  public List<WaitsFor> keepWhatIsWanted() {
    Set<Resource> wanted = wanted();
    List<WaitsFor> obstacles = leases().obstaclesToKeep(goalId, wanted);
    if (obstacles.isEmpty()) {
      leases().keep(goalId, wanted);
      writeDown();
    }
    return obstacles;
  }

  /** What others have of what these steps need, if they were to begin now. */
  public List<WaitsFor> obstaclesToPlan(Collection<Step> steps) {
    return leases().obstaclesToKeep(goalId, components(steps));
  }

  /** What keeps a step from beginning though all components are kept. */
  public List<WaitsFor> obstacles(Step step) {
    List<WaitsFor> obstacles = new ArrayList<>(leases().obstaclesToRun(goalId, uses(step)));
    Snapshot now = ports.knowledge().snapshot();
    List<Change> changes = changes(step, now);
    if (!changes.isEmpty()) {
      for (ActiveGoal other : activeGoals.others(goalId)) {
        other
            .countsOn(changes, now, goalId)
            .ifPresent(
                fact ->
                    obstacles.add(
                        new WaitsFor(
                            goalId,
                            Resource.fact(new Sentences(vocabulary()).fact(fact)),
                            other.id())));
      }
    }
    return obstacles;
  }

  private static List<Change> changes(Step step, Snapshot before) {
    return new Evaluation(before).changes(step.feature().effect(), step.values());
  }

  /** The step takes what it uses. */
  public Set<Resource> begin(Step step) {
    Set<Resource> used = uses(step);
    leases().run(goalId, step.member(), used);
    return used;
  }

  public void ended(Step step, Set<Resource> used) {
    leases().ended(goalId, step.member(), used);
  }

  /** Remembers what the step brought about, and what its member holds since. */
  public void done(Step step, Snapshot before) {
    List<Change> changes = changes(step, before);
    FactFilter subjects = broughtAbout.orElseGet(() -> new FactFilter(vocabulary()));
    subjects.addChanges(changes);
    broughtAbout = Optional.of(subjects);
    for (Change change : changes) {
      if (change instanceof Change.OfTruth truth
          && truth.value()
          && isHeldBy(step.member(), truth.atom())) {
        carried.add(truth.atom());
      }
    }
    writeDown();
  }

  /** A fact about something else that names the member: it has that thing. */
  private static boolean isHeldBy(String member, Formula.Atom atom) {
    Term.Name name = new Term.Name(member);
    return atom.arguments().lastIndexOf(name) > 0 && !atom.arguments().get(0).equals(name);
  }

  /** Whether the member carries something for this goal. */
  public boolean isTied(String member) {
    return isTied() && carried.stream().anyMatch(atom -> isHeldBy(member, atom));
  }

  /** Whether any member does. */
  public boolean isTied() {
    Snapshot now = ports.knowledge().snapshot();
    carried.removeIf(atom -> now.truth(atom) == Truth.FALSE);
    return !carried.isEmpty();
  }

  /** What is not needed any more by what is left of the plan is let go. */
  public void letGoOfWhatIsDone() {
    Set<Resource> spare = leases().kept(goalId);
    spare.removeAll(components(plan.needed()));
    spare.removeIf(resource -> isTied(resource.owner()));
    leases().letGo(goalId, spare);
    leases().moved(goalId);
    writeDown();
  }

  /** Lets go of all that no step is using and no member is tied to. */
  public void letGo() {
    Set<Resource> spare = leases().kept(goalId);
    spare.removeAll(components(underway.steps()));
    spare.removeIf(resource -> isTied(resource.owner()));
    leases().letGo(goalId, spare);
    leases().moved(goalId);
    writeDown();
  }

  /** Lets go even of what it carries. */
  public void letGoOfAll() {
    carried.clear();
    letGo();
  }

  boolean hasAnything() {
    return !underway.isEmpty() || !leases().kept(goalId).isEmpty();
  }

  /** Whether one of the resources is in use by a running step, or tied to this goal. */
  public boolean needsNow(Collection<Resource> resources) {
    Set<Resource> used = components(underway.steps());
    return resources.stream().anyMatch(r -> used.contains(r) || isTied(r.owner()));
  }

  /**
   * What the changes would spoil for this goal, if anything.
   *
   * @param wholeGoal all of the goal is to stay so, whoever brought it about
   * @param goesFirst all that the rest of its plan needs counts, not only what it has brought about
   */
  public Optional<Formula> spoiledBy(
      List<Change> changes, Snapshot now, boolean wholeGoal, boolean goesFirst) {
    CausalLinks causalLinks = new CausalLinks(vocabulary());
    underway.steps().forEach(causalLinks::addConditions);
    if (goesFirst && (hasAnything() || plan.hasBegun())) {
      plan.remaining().forEach(causalLinks::addConditions);
    } else {
      broughtAbout.ifPresent(
          about ->
              plan.remaining().forEach(step -> causalLinks.addAchievedConditions(step, about)));
    }
    if (wholeGoal) {
      causalLinks.addAll(request.goal(), plan.goalBinding());
    } else {
      broughtAbout.ifPresent(
          about -> causalLinks.addAchieved(request.goal(), plan.goalBinding(), about));
    }
    return causalLinks.brokenBy(changes, now);
  }
}
