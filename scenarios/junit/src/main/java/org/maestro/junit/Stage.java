package org.maestro.junit;

import java.net.URI;
import java.time.Duration;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;
import java.util.function.BooleanSupplier;
import org.maestro.agents.content.AskedGoal;
import org.maestro.assembly.LocalSite;
import org.maestro.assembly.SiteSettings;
import org.maestro.hal.Drivers;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.platform.MaestroPlatform;
import org.maestro.rats.member.MemberProfile;
import org.maestro.rats.member.RatsMember;
import org.maestro.rats.time.Clock;
import org.maestro.rats.time.SteppedClock;
import org.maestro.sim.world.World;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlSyntaxException;

/**
 * A running platform with the simulated home behind it, as a test sees it. Time passes only while
 * the test waits when the clock is stepped. For the test's thread.
 */
public final class Stage implements AutoCloseable {

  private static final Duration LONGEST_SILENCE = Duration.ofHours(2);
  private static final Duration PATIENCE = Duration.ofMinutes(10);
  private static final Duration PACED_PATIENCE = Duration.ofMinutes(1);

  private final LocalSite site;
  private final Duration patience;
  private final Duration listening;
  private final Map<String, Speaker> speakers = new TreeMap<>();

  Stage(LocalSite site, Duration patience) {
    this.site = site;
    this.patience = patience;
    this.listening = site.clock().isStepped() ? LONGEST_SILENCE : patience;
  }

  /**
   * A stage of one's own on the stepped clock, for tests that make their home themselves. To be
   * closed by the test.
   *
   * @param site in any case another name for each stage
   */
  public static Stage stepped(SiteSettings site) {
    return new Stage(LocalSite.stepped(site), PATIENCE);
  }

  /**
   * The same, with what is due at the same time in another order for each seed: what a platform
   * does must not depend on it.
   */
  public static Stage shuffled(SiteSettings site, long seed) {
    return new Stage(LocalSite.stepped(site, SteppedClock.shuffled(seed)), PATIENCE);
  }

  /**
   * The same on the wall's time and over a broker, for tests with devices in other processes.
   *
   * @param site without a broker: it gets one of its own
   */
  public static Stage paced(SiteSettings site) {
    return new Stage(LocalSite.paced(site, 1), PACED_PATIENCE);
  }

  /** Where devices in other processes join. */
  public URI broker() {
    return site.broker().orElseThrow(() -> new StageException("The stage is within the process"));
  }

  /** States a goal and waits for its end. A goal that is not MAESTRO-SL is a refused one. */
  public GoalOutcome goal(String goal) {
    return begin(goal).await();
  }

  /** States a goal, and leaves it under way. */
  public Pursuit begin(String goal) {
    try {
      return Pursuit.begin(site, goal, parsed(goal), patience);
    } catch (SlSyntaxException e) {
      return Pursuit.refused(site, goal, Objects.requireNonNullElse(e.getMessage(), e.toString()));
    }
  }

  /** States a goal of which more is said, such as its priority, and leaves it under way. */
  public Pursuit begin(AskedGoal goal) {
    return Pursuit.begin(site, goal, patience);
  }

  /** A person of the home, by her name there, who speaks; each time the same. */
  public Speaker speaker(String person) {
    return speakers.computeIfAbsent(person, name -> new Speaker(site, name, listening).listening());
  }

  /** A room of the home, by its name there, in which is heard what is said from now on. */
  public Room room(String room) {
    return new Room(site, room, listening);
  }

  /** The persons of the home, who walk about in it. */
  public Persons persons() {
    return new Persons(site, patience);
  }

  /** What the platform knows. */
  public KnowledgeBase knowledge() {
    return site.platform().knowledge();
  }

  /** The truth behind it: ask it, and change it. */
  public World world() {
    return site.world();
  }

  /** The hardware of a device as it truly is, whatever the device says of itself. */
  public Drivers drivers(String device) {
    return site.simulated().drivers(device);
  }

  public MaestroPlatform platform() {
    return site.platform();
  }

  public Clock clock() {
    return site.clock();
  }

  /** Lets simulated time pass. */
  public void run(Duration time) {
    site.runUntil(() -> false, time);
  }

  /** Lets time pass until the condition holds; fails the test when it does not in time. */
  public void await(String what, BooleanSupplier condition) {
    if (!site.runUntil(condition, patience)) {
      throw new StageException("It did not happen within " + patience + ": " + what + ".");
    }
  }

  /**
   * The device's power fails: it vanishes from the bus without goodbye, and lets go of what it
   * holds.
   */
  public void kill(String device) {
    site.world().die(device);
  }

  /** The device is switched on again, and joins anew. */
  public void revive(String device) {
    site.world().revive(device);
  }

  /**
   * A member that is none of the home's devices joins the bus, with a description of its own; it
   * leaves with the stage.
   */
  public RatsMember join(MemberProfile profile, MemberProfile.Values values) {
    return site.join(profile, values);
  }

  @Override
  public void close() {
    site.close();
  }

  private Formula parsed(String goal) {
    return SlParser.formula(goal, knowledge().home().vocabulary()::isFluent);
  }
}
