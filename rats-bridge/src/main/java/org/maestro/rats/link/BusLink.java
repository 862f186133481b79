package org.maestro.rats.link;

import java.time.Duration;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import org.maestro.rats.protocol.Call;
import org.maestro.rats.protocol.Complaints;
import org.maestro.rats.protocol.CostAnswer;
import org.maestro.rats.protocol.MalformedMessageException;
import org.maestro.rats.protocol.Observation;
import org.maestro.rats.protocol.Offer;
import org.maestro.rats.protocol.Release;
import org.maestro.rats.protocol.ReservedFeature;
import org.maestro.rats.protocol.Topics;
import org.maestro.rats.protocol.Verdict;
import org.maestro.rats.protocol.WireFormat;
import org.maestro.rats.time.Clock;
import org.maestro.rats.transport.Message;
import org.maestro.rats.transport.Transport;
import org.maestro.rats.transport.Transport.RetainedMessages;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The link over a {@link Transport}. Everything happens on the clock's thread, also the listeners
 * are told there. On a stepped clock with the in-process transport a call under way needs no
 * ticket: each of its hops is an action of the clock.
 */
public final class BusLink implements RatsLink {

  private static final Logger LOG = LoggerFactory.getLogger(BusLink.class);

  /** Wall time, so that nobody is too slow for a fast clock. */
  private static final Duration ASK_ALL_TIMEOUT = Duration.ofSeconds(30);

  /** Wall time that members have to show up again after the bus was away. */
  private static final Duration RETURN_LIMIT = Duration.ofSeconds(5);

  private final String controller;
  private final CallIds ids;
  private final Topics topics;
  private final Transport transport;
  private final Clock clock;
  private final WireFormat wire = new WireFormat();
  private final Complaints complaints = new Complaints();
  private final ControllerStatus status;
  private final Verdicts verdicts;
  private final Roster roster;
  private final OpenCalls calls;
  private final Watchers watchers = new Watchers();
  private final Hearing hearing;
  private final MissingWords missing;
  private final LifeQuestions lifeQuestions;
  private final Subscriptions subscriptions;
  private final AtomicBoolean closed = new AtomicBoolean();
  private Optional<Clock.Timer> doubtEnds = Optional.empty();
  private boolean wasConnected;
  private volatile Optional<String> absence = Optional.of("it was not reached yet");

  private BusLink(
      String controller, Topics topics, Transport transport, Clock clock, boolean ofAll) {
    this.controller = controller;
    this.ids = new CallIds(controller, "", clock);
    this.topics = topics;
    this.transport = transport;
    this.clock = clock;
    this.status = new ControllerStatus(controller, ids.life(), topics, transport);
    this.verdicts = new Verdicts(controller, topics, transport);
    this.calls = new OpenCalls(controller, topics, transport, clock, complaints);
    this.lifeQuestions = new LifeQuestions(controller, calls, ids::next, clock);
    this.roster = new Roster(topics, complaints, new RosterWatcher());
    Hearing.Handlers handlers =
        new Hearing.Handlers(
            roster::statusHeard,
            roster::descriptionHeard,
            roster::stateHeard,
            this::observationHeard);
    this.missing = new MissingWords(controller, roster::known, new Questions(), clock);
    this.subscriptions = new Subscriptions(controller, topics, transport, clock, complaints);
    this.hearing = new Hearing(ofAll, topics, handlers, subscriptions);
  }

  /**
   * Joins the site as a controller; members become known some messages later.
   *
   * @param controller its id, a level of topics; also the transport's client id
   * @param transport not open yet; closed with the link
   */
  public static BusLink connect(String controller, String site, Transport transport, Clock clock) {
    return connect(controller, site, transport, clock, SiteKind.OPEN);
  }

  /** The same, for a site that may be secured. */
  public static BusLink connect(
      String controller, String site, Transport transport, Clock clock, SiteKind kind) {
    BusLink link = new BusLink(controller, new Topics(site), transport, clock, true);
    link.open(kind);
    return link;
  }

  /**
   * The same, but it hears of those members only that are watched one by one, and {@link #members}
   * has no others: for who has a few of many members.
   */
  public static BusLink connectForWatched(
      String controller, String site, Transport transport, Clock clock, SiteKind kind) {
    BusLink link = new BusLink(controller, new Topics(site), transport, clock, false);
    link.open(kind);
    return link;
  }

  @Override
  public String controller() {
    return controller;
  }

  @Override
  public Optional<String> absence() {
    return absence;
  }

  @Override
  public Collection<Member> members() {
    return roster.members();
  }

  @Override
  public void watch(MemberListener listener) {
    afterwards(
        () -> {
          watchers.add(listener);
          roster.members().forEach(listener::changed);
        });
  }

  @Override
  public Runnable watch(String member, MemberListener listener) {
    afterwards(
        () -> {
          watchers.add(member, listener);
          if (hearing.follow(member)) {
            missing.expect(member);
          }
          roster.member(member).ifPresent(listener::changed);
        });
    return () -> afterwards(() -> watchers.remove(member, listener));
  }

  @Override
  public CallHandle call(Order order, CallListener listener) {
    Call call = worded(order);
    perform(() -> calls.begin(call, order.grace(), roster.readyBoot(order.member()), listener));
    return handle(call);
  }

  @Override
  public CallHandle end(Order order, CallListener listener) {
    Call call = worded(order);
    perform(
        () ->
            calls.end(call, order.grace(), roster.readyBoot(order.member()), ids.next(), listener));
    return handle(call);
  }

  private Call worded(Order order) {
    Call call =
        new Call(
            order.id().orElseGet(ids::next),
            Optional.of(order.member()),
            order.boot(),
            order.feature(),
            order.parameters(),
            order.timeout(),
            controller,
            order.task(),
            order.expects());
    // Parameters that JSON cannot hold are the caller's fault, and are told to the caller's face.
    wire.require(call);
    return call;
  }

  private CallHandle handle(Call call) {
    return new Handle(call.id(), () -> perform(() -> calls.cancel(call.id(), ids.next())));
  }

  @Override
  public void cancel(String member, String boot, String callId) {
    String cancelId = ids.next();
    perform(() -> calls.sendCancel(member, Optional.of(boot), callId, cancelId));
  }

  @Override
  public void cost(
      String member,
      String feature,
      List<Map<String, Object>> parameterSets,
      Consumer<List<CostAnswer>> answer) {
    CostQuestion question = new CostQuestion(feature, parameterSets, answer);
    call(
        member,
        ReservedFeature.COST.word(),
        question.parameters(),
        CostQuestion.TIMEOUT,
        Optional.empty(),
        question);
  }

  @Override
  public void describe(String member) {
    perform(() -> ask(Optional.of(member), ReservedFeature.DESCRIBE));
  }

  @Override
  public void describe(String member, Duration within, Runnable over) {
    call(
        member,
        ReservedFeature.DESCRIBE.word(),
        Map.of(),
        within,
        Optional.empty(),
        result -> over.run());
  }

  @Override
  public void tell(Verdict verdict) {
    verdicts.tell(verdict);
  }

  @Override
  public void safe() {
    perform(() -> ask(Optional.empty(), ReservedFeature.SAFE));
  }

  @Override
  public void safe(String member) {
    perform(() -> ask(Optional.of(member), ReservedFeature.SAFE));
  }

  @Override
  public void close() {
    if (closed.compareAndSet(false, true)) {
      clock.schedule(Duration.ZERO, controller, calls::closeAll);
      clock.schedule(Duration.ZERO, controller, missing::end);
      clock.schedule(Duration.ZERO, controller, lifeQuestions::end);
      status.leave();
      verdicts.leave();
      transport.close();
    }
  }

  private void open(SiteKind kind) {
    hearing.begin();
    subscriptions.subscribe(
        topics.results(controller), RetainedMessages.IGNORE, calls::resultHeard);
    if (kind == SiteKind.OPEN) {
      subscriptions.subscribe(topics.bareResult(), RetainedMessages.IGNORE, calls::resultHeard);
      subscriptions.subscribe(
          topics.controllerStatus(controller), RetainedMessages.IGNORE, status::heard);
    }
    subscriptions.subscribe(
        topics.progresses(controller), RetainedMessages.IGNORE, calls::progressHeard);
    transport.subscribeToOthers(
        topics.calls(),
        message -> {
          if (!wire.isForAnother(message.payload(), controller)) {
            perform(() -> callHeard(message));
          }
        });
    transport.open(
        Optional.of(status.will()),
        new Transport.ConnectionListener() {
          @Override
          public void connected() {
            absence = Optional.empty();
            perform(BusLink.this::connected);
          }

          @Override
          public void lost(String reason) {
            LOG.debug("{} lost the bus: {}", controller, reason);
            absence = Optional.of(reason);
            perform(BusLink.this::lost);
          }
        });
  }

  private void connected() {
    status.ready();
    verdicts.tellAgain();
    clock.schedule(
        clock.ofWall(MissingWords.FIRST_WAIT),
        controller,
        () -> hearing.addressees().forEach(member -> ask(member, ReservedFeature.DESCRIBE)));
    if (hearing.isOfAll()) {
      missing.lookForStrangers();
    }
    if (wasConnected) {
      calls.resume();
      doubtEnds.ifPresent(Clock.Timer::cancel);
      doubtEnds =
          Optional.of(clock.schedule(clock.ofWall(RETURN_LIMIT), controller, roster::dropDoubted));
    }
    wasConnected = true;
  }

  /**
   * @param member empty: all
   */
  private void ask(Optional<String> member, ReservedFeature reserved) {
    if (!closed.get()) {
      calls.sendUnwatched(
          new Call(
              ids.next(),
              member,
              Optional.empty(),
              reserved.word(),
              Map.of(),
              clock.ofWall(ASK_ALL_TIMEOUT),
              controller,
              Optional.empty()));
    }
  }

  /**
   * Before any status is heard on the next connection, which may be before that is told to be
   * there.
   */
  private void lost() {
    doubtEnds.ifPresent(Clock.Timer::cancel);
    roster.doubtAll();
  }

  private void observationHeard(Message message) {
    topics
        .memberOf(message.topic())
        .ifPresent(
            sender -> {
              Observation observation = wire.decodeObservation(message.payload());
              boolean belongs = calls.observed(sender, observation);
              if (!belongs && observation.feature().equals(ReservedFeature.ALERT)) {
                alerted(sender, observation);
              }
            });
  }

  /** An alarm is heard also when its call has ended, or is unknown here. */
  private void alerted(String member, Observation alert) {
    String text = String.valueOf(alert.values().get("message"));
    watchers.alerted(member, alert.id(), text);
  }

  /**
   * What members have to say to the holder of a contract. A controller has no features: what is no
   * call of these is for members to judge.
   */
  private void callHeard(Message message) {
    Call call;
    try {
      call = wire.decodeCall(message.payload());
    } catch (MalformedMessageException malformed) {
      LOG.debug("On {}: {}", message.topic(), malformed.getMessage());
      return;
    }
    boolean forMe = call.member().filter(controller::equals).isPresent() && !message.retained();
    Optional<String> sender = topics.callerOf(message.topic()).filter(call.from()::equals);
    if (forMe && sender.isPresent() && call.feature().equals(ReservedFeature.OFFER)) {
      Offer.of(call.parameters()).ifPresent(offer -> calls.offered(sender.get(), offer));
    } else if (forMe && sender.isPresent() && call.feature().equals(ReservedFeature.RELEASE)) {
      Release.of(call.parameters()).ifPresent(release -> calls.released(sender.get(), release));
    }
  }

  /** What tells a listener does not do so on the thread that asks for it. */
  private void afterwards(Runnable action) {
    clock.schedule(Duration.ZERO, controller, action);
  }

  private void perform(Runnable action) {
    clock.perform(controller, action);
  }

  private final class Questions implements MissingWords.Questions {
    @Override
    public void ask(String member) {
      BusLink.this.ask(Optional.of(member), ReservedFeature.DESCRIBE);
    }

    @Override
    public void lookForStrangers() {
      transport.askForRetained(topics.statuses());
    }
  }

  private final class RosterWatcher implements Roster.Watcher {
    @Override
    public void changed(Member member) {
      watchers.changed(member);
    }

    @Override
    public boolean asks(String member, String life, Consumer<Boolean> isAlive) {
      return lifeQuestions.ask(member, life, isAlive);
    }

    @Override
    public void gone(String member, String life, String why) {
      calls.memberGone(member, life, why);
    }

    @Override
    public void returned(String member) {
      calls.resume(member);
    }

    @Override
    public void noticed(String member) {
      missing.expect(member);
    }
  }
}
