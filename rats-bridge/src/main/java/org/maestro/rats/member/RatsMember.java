package org.maestro.rats.member;

import java.time.Duration;
import java.time.Instant;
import java.util.Collections;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.maestro.rats.protocol.Complaints;
import org.maestro.rats.protocol.MalformedMessageException;
import org.maestro.rats.protocol.MemberState;
import org.maestro.rats.protocol.MemberStatus;
import org.maestro.rats.protocol.Topics;
import org.maestro.rats.protocol.WireFormat;
import org.maestro.rats.time.Clock;
import org.maestro.rats.transport.Message;
import org.maestro.rats.transport.Transport;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A member of the bus, r = (Id, F, Z, z, Zs) of the paper's section 3.2.1: announces itself,
 * executes calls, answers them. All of it happens on the clock's thread. The transport is its own:
 * opened here, closed with it.
 *
 * <p>Any thread may {@link #close} it, or let it {@link #leave} or {@link #die}; the other methods
 * belong to the clock's thread.
 */
public final class RatsMember implements AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(RatsMember.class);

  private final MemberProfile profile;
  private final Topics topics;
  private final Transport transport;
  private final Clock clock;
  private final String boot;
  private final WireFormat wire = new WireFormat();
  private final MemberPublisher voice;
  private final MemberCondition condition;
  private final Reception reception;
  private final Impatience impatience;
  private final CallPolicy policy;
  private final ControllerWatch controllers;
  private final Namesake namesake;
  private Optional<Clock.Timer> byTime = Optional.empty();
  private String restedIn;
  private boolean announced;
  private boolean connected;
  private boolean changePending;
  private Optional<MemberState> told = Optional.empty();

  private RatsMember(
      MemberProfile profile,
      MemberProfile.Values values,
      Transport transport,
      Topics topics,
      CallPolicy policy,
      Complaints complaints,
      Clock clock) {
    this.profile = profile;
    this.topics = topics;
    this.transport = transport;
    this.clock = clock;
    this.boot = bootId(clock.instant());
    this.restedIn = "";
    this.voice = new MemberPublisher(profile, boot, topics, transport);
    this.condition = new MemberCondition(profile, boot, values);
    CallAnswers answers = new CallAnswers(profile.id(), voice, condition, clock);
    TaskQueue tasks =
        new TaskQueue(
            profile, voice, condition, answers, this::tellState, this::stateChanged, clock);
    this.controllers = new ControllerWatch(profile.id(), topics, profile.rules(), tasks, clock);
    this.policy = policy;
    this.namesake =
        new Namesake(profile.id(), boot, voice, transport, complaints, new StatusWatcher(), clock);
    this.impatience = new Impatience(profile, policy, voice, condition, tasks, clock);
    this.reception =
        new Reception(
            profile,
            boot,
            topics,
            policy,
            condition,
            answers,
            tasks,
            impatience,
            namesake::mayBe,
            this::describe,
            complaints,
            clock);
  }

  /**
   * Joins the site. The member is ready some messages later.
   *
   * @param values what it reports of itself, asked at each change
   * @param transport not open yet; its client id is the member's id
   * @param site the site's name, see {@link Topics}
   */
  public static RatsMember start(
      MemberProfile profile,
      MemberProfile.Values values,
      Transport transport,
      String site,
      Clock clock) {
    return start(profile, values, transport, site, CallPolicy.OPEN, clock);
  }

  /**
   * Joins a site whose rules say who may call what.
   *
   * @param policy asked before anything is done for a caller
   */
  public static RatsMember start(
      MemberProfile profile,
      MemberProfile.Values values,
      Transport transport,
      String site,
      CallPolicy policy,
      Clock clock) {
    return start(profile, values, transport, site, policy, new Complaints(), clock);
  }

  /**
   * Joins as one of several members that share a log.
   *
   * @param complaints the same for all of them: what all hear is complained of once
   */
  public static RatsMember start(
      MemberProfile profile,
      MemberProfile.Values values,
      Transport transport,
      String site,
      CallPolicy policy,
      Complaints complaints,
      Clock clock) {
    RatsMember member =
        new RatsMember(profile, values, transport, new Topics(site), policy, complaints, clock);
    member.open();
    return member;
  }

  public String id() {
    return profile.id();
  }

  /**
   * A member and the state it is in: r = (Id, F, Z, z, Zs) of the paper's section 3.2.1
   * (Three-layered architecture, 3.2.1; M32).
   *
   * @param features F, the ids of those that it has, disabled ones too
   * @param states Z; {@code state}, z, is one of them, {@code safeStates} some
   */
  public record Tuple(
      String id, Set<String> features, Set<String> states, String state, Set<String> safeStates) {}

  /** As it is now. */
  public Tuple tuple() {
    return new Tuple(
        profile.id(),
        Collections.unmodifiableSet(new TreeSet<>(profile.features().keySet())),
        Collections.unmodifiableSet(new TreeSet<>(profile.states())),
        condition.state(),
        Collections.unmodifiableSet(new TreeSet<>(profile.safeStates())));
  }

  /** Names this life of the member: another start has another. */
  public String boot() {
    return boot;
  }

  /** To be called when something changed that {@link MemberProfile.Values} tells. */
  public void stateChanged() {
    if (!changePending) {
      changePending = true;
      clock.schedule(Duration.ZERO, profile.id(), this::tellPendingChange);
    }
  }

  /**
   * The member is in another state while at rest, by the world's doing or by time (Three-layered
   * architecture, 3.2.1; M35).
   *
   * @throws IllegalArgumentException when that is none of its states, or may not follow the present
   *     one
   */
  public void rest(String state) {
    condition.rest(state);
    stateChanged();
  }

  /**
   * Refuses calls of the feature from now on (Three-layered architecture, 3.2.1; M33); the reason
   * is told to callers.
   */
  public void disable(String feature, String reason) {
    condition.disable(feature, reason);
    stateChanged();
  }

  public void enable(String feature) {
    condition.enable(feature);
    stateChanged();
  }

  /** Begins to leave as {@link #close} does, and does not wait until the broker has taken it. */
  public void leave() {
    if (namesake.isAway()) {
      voice.silence();
    } else {
      voice.leave();
    }
    transport.leave();
  }

  /**
   * Leaves for good: clears what is retained of it, and closes the transport. Running calls stay
   * without an answer.
   */
  @Override
  public void close() {
    leave();
    transport.close();
  }

  /** Vanishes without goodbye, as when its power fails. */
  public void die() {
    voice.silence();
    transport.die();
  }

  private void open() {
    boolean overhears = Impatience.isOf(profile);
    // On a secured site only controllers read what members say of themselves.
    if (!policy.isSecured()) {
      transport.subscribe(
          topics.description(profile.id()),
          Transport.RetainedMessages.SEND,
          message -> perform(() -> whenConnected(() -> namesake.descriptionHeard(message))));
    }
    if (overhears && !policy.isSecured()) {
      transport.subscribe(
          topics.states(),
          Transport.RetainedMessages.IGNORE,
          message -> perform(() -> readStateOfAnother(message)));
    }
    transport.subscribe(
        topics.calls(),
        Transport.RetainedMessages.IGNORE,
        message -> {
          if (!overhears && wire.isForAnother(message.payload(), profile.id())) {
            return;
          }
          Duration arrivedAt = clock.now();
          perform(() -> callHeard(message, arrivedAt));
        });
    transport.subscribe(
        topics.results(profile.id()),
        Transport.RetainedMessages.IGNORE,
        message -> perform(() -> namesake.answered(message)));
    transport.subscribe(
        topics.status(profile.id()),
        Transport.RetainedMessages.SEND,
        message -> perform(() -> whenConnected(() -> namesake.statusHeard(message))));
    transport.subscribe(
        topics.controllerStatuses(),
        Transport.RetainedMessages.SEND,
        message -> perform(() -> controllers.heard(message)));
    watchTheTime();
    transport.open(
        Optional.of(voice.will()),
        new Transport.ConnectionListener() {
          @Override
          public void connected() {
            perform(RatsMember.this::connected);
          }

          @Override
          public void lost(String reason) {
            perform(RatsMember.this::disconnected);
          }
        });
  }

  private void perform(Runnable action) {
    clock.perform(
        profile.id(),
        () -> {
          if (!voice.silent()) {
            action.run();
          }
        });
  }

  /** While another of its id is there, or may be, calls are for that one. */
  private void callHeard(Message message, Duration arrivedAt) {
    if (!namesake.isAway()) {
      reception.heard(message, arrivedAt);
    }
  }

  private void disconnected() {
    connected = false;
    namesake.dropped();
  }

  private void connected() {
    if (!namesake.looksFirst()) {
      announce();
    }
  }

  /** After each connect, since the broker may have come back empty. */
  private void announce() {
    connected = true;
    if (!announced) {
      voice.status(MemberStatus.Phase.INIT);
    }
    announced = true;
    LOG.debug("On the bus: {}", tuple());
    describe();
    voice.sendUnsent();
  }

  private void describe() {
    voice.description();
    told = Optional.of(condition.snapshot());
    voice.state(told.get());
    voice.status(MemberStatus.Phase.READY);
  }

  private void whenConnected(Runnable action) {
    if (connected) {
      action.run();
    }
  }

  private void readStateOfAnother(Message message) {
    try {
      impatience.heard(wire.decodeState(message.payload()));
    } catch (MalformedMessageException malformed) {
      LOG.debug("{} heard a malformed state: {}", profile.id(), malformed.getMessage());
    }
  }

  /** Whether it is off the bus because another member of its id is there. Any thread. */
  public boolean isRefused() {
    return namesake.isAway();
  }

  private void tellPendingChange() {
    changePending = false;
    tellState();
  }

  private void tellState() {
    watchTheTime();
    MemberState now = condition.snapshot();
    if (connected && told.filter(now::saysTheSameAs).isEmpty()) {
      told = Optional.of(now);
      voice.state(now);
      impatience.changed();
    }
  }

  /** A state that the member may only rest in for a while is left by itself. */
  private void watchTheTime() {
    String resting = condition.isBusy() ? "" : condition.atRest();
    if (resting.equals(restedIn)) {
      return;
    }
    restedIn = resting;
    byTime.ifPresent(Clock.Timer::cancel);
    byTime =
        Optional.ofNullable(profile.rules().byTime().get(resting))
            .map(after -> clock.schedule(after.time(), profile.id(), () -> rest(after.state())));
  }

  private static String bootId(Instant instant) {
    return Long.toString(instant.getEpochSecond() * 1_000_000_000L + instant.getNano(), 36);
  }

  private final class StatusWatcher implements Namesake.Watcher {
    @Override
    public void contradicted() {
      voice.status(MemberStatus.Phase.READY);
    }

    @Override
    public void cleared() {
      describe();
    }

    @Override
    public void misdescribed() {
      whenConnected(voice::description);
    }

    @Override
    public void left() {
      connected = false;
    }

    @Override
    public void stays() {
      announce();
    }
  }
}
