package org.maestro.experiment.running;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BooleanSupplier;
import org.maestro.agents.content.GoalReport;
import org.maestro.assembly.LocalSite;
import org.maestro.coordination.api.Story;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.ontology.home.NamedPoints;
import org.maestro.rats.member.MemberProfile;
import org.maestro.rats.time.Clock;
import org.maestro.sim.SimulatedHome;
import org.maestro.sim.world.World;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.Substitution;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/** The platform of a trial. To be closed. For one thread. */
public final class TrialSite implements AutoCloseable {
  private final LocalSite site;

  private TrialSite(LocalSite site) {
    this.site = site;
  }

  public static TrialSite open(Trial trial) {
    return new TrialSite(trial.open());
  }

  /** A goal under way. */
  public final class Underway {
    private final String goal;
    private final Duration begun = site.clock().now();
    private final AtomicReference<String> id = new AtomicReference<>("");
    private final AtomicReference<GoalReport> report = new AtomicReference<>();
    private final List<StoryEntry> told = new ArrayList<>();

    private Underway(String goal) {
      this.goal = goal;
      site.platform().onStory(this::tell);
      site.platform().desk().pursue(parsed(goal), id::set, report::set);
    }

    private synchronized void tell(StoryEntry entry) {
      told.add(entry);
    }

    public boolean hasEnded() {
      return report.get() != null;
    }

    /** How it ended; how it stands, while it has not. */
    public synchronized Ending ending() {
      return new Ending(
          goal,
          Optional.ofNullable(report.get()),
          told.stream().filter(entry -> entry.goalId().equals(id.get())).toList(),
          begun);
    }
  }

  /** Tells the listener every sentence of every goal from now on, on threads of the platform. */
  public void listen(Story listener) {
    site.platform().onStory(listener);
  }

  /** A person of the home, who listens from now on. */
  public Conversation conversation(String person) {
    return Conversation.begin(site, person);
  }

  /** States a goal, and leaves it under way. */
  public Underway begin(String goal) {
    return new Underway(goal);
  }

  /**
   * States a goal and waits for its end.
   *
   * @param patience simulated time, after which it is left
   */
  public Ending pursue(String goal, Duration patience) {
    Underway underway = begin(goal);
    runUntil(underway::hasEnded, patience);
    return underway.ending();
  }

  /**
   * Whether it is so in the simulated world, whatever the platform says; unknown of what the world
   * cannot tell, such as whether a script was carried out.
   *
   * @param binding values of its free variables; something is looked for that fits the others
   */
  public Truth truth(String goal, Map<String, Term> binding) {
    Formula bound = new Substitution(binding).apply(parsed(goal));
    return isScript(bound)
        ? Truth.UNKNOWN
        : new TrueFacts(NamedPoints.of(bound).in(site.home()), site.simulated()).of(bound);
  }

  private boolean isScript(Formula goal) {
    return goal instanceof Formula.Atom atom && site.home().scripts().containsKey(atom.predicate());
  }

  /** Lets simulated time pass until the condition holds; says whether it does. */
  public boolean runUntil(BooleanSupplier condition, Duration limit) {
    return site.runUntil(condition, limit);
  }

  /** Lets simulated time pass. */
  public void run(Duration time) {
    site.runUntil(() -> false, time);
  }

  public World world() {
    return site.world();
  }

  /** The member goes from the bus, and works on by itself; on the stepped clock only. */
  public void cut(String member) {
    site.bus().cut(member);
  }

  /** It is back. */
  public void mend(String member) {
    site.bus().mend(member);
  }

  /** A member that is none of the simulated devices joins; it leaves with the site. */
  public void join(MemberProfile profile, MemberProfile.Values values) {
    site.join(profile, values);
  }

  public SimulatedHome simulated() {
    return site.simulated();
  }

  public Clock clock() {
    return site.clock();
  }

  private Formula parsed(String goal) {
    return SlParser.formula(goal, site.platform().knowledge().home().vocabulary()::isFluent);
  }

  @Override
  public void close() {
    site.close();
  }
}
