package org.maestro.rats.link;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import org.maestro.rats.protocol.Call;
import org.maestro.rats.protocol.Complaints;
import org.maestro.rats.protocol.CostAnswer;
import org.maestro.rats.protocol.MemberStatus;
import org.maestro.rats.protocol.ReservedFeature;
import org.maestro.rats.protocol.Topics;
import org.maestro.rats.protocol.WireFormat;
import org.maestro.rats.time.Clock;
import org.maestro.rats.transport.Message;
import org.maestro.rats.transport.Publication;
import org.maestro.rats.transport.Transport;
import org.maestro.rats.transport.Transport.RetainedMessages;

/**
 * Calls and cost questions of a member to others, in its own name and over the one connection that
 * it has: a secured broker lets nobody have two. The member called decides by the site's rules. Any
 * thread may call; nothing blocks; listeners are told on the clock's thread.
 *
 * <p>Of those it calls it hears results, progress and whether they are there, which every user of a
 * secured site may read; of continuous features that is the first values, since what comes after
 * them is for controllers only.
 */
public final class MemberCalls {

  /**
   * Wall time in which a loaded broker sends what is retained; who is not known then is not there.
   */
  private static final Duration STATUS_LIMIT = Duration.ofSeconds(5);

  private final String member;
  private final CallIds ids;
  private final Topics topics;
  private final Transport transport;
  private final Clock clock;
  private final WireFormat wire = new WireFormat();
  private final Roster roster;
  private final OpenCalls calls;
  private final Subscriptions subscriptions;
  private final LifeQuestions lifeQuestions;
  private final Set<String> followed = new HashSet<>();
  private final Map<String, List<Runnable>> awaiting = new HashMap<>();

  /**
   * @param member the caller's id, under which it is a member too
   * @param transport not open yet; the member has to be started with {@link #transport}
   */
  public MemberCalls(String member, String site, Transport transport, Clock clock) {
    this.member = member;
    this.ids = new CallIds(member, "asks-", clock);
    this.topics = new Topics(site);
    this.transport = transport;
    this.clock = clock;
    Complaints complaints = new Complaints();
    this.roster = new Roster(topics, complaints, new Presence());
    this.calls = new OpenCalls(member, topics, transport, clock, complaints);
    this.lifeQuestions = new LifeQuestions(member, calls, ids::next, clock);
    this.subscriptions = new Subscriptions(member, topics, transport, clock, complaints);
  }

  /** The same connection, for the member itself. */
  public Transport transport() {
    return new Shared();
  }

  /**
   * @throws IllegalArgumentException when it calls itself, or parameters are nothing for JSON
   */
  public RatsLink.CallHandle call(
      String called,
      String feature,
      Map<String, Object> parameters,
      Duration timeout,
      RatsLink.CallListener listener) {
    if (called.equals(member)) {
      throw new IllegalArgumentException(member + " calls itself; it can do it without a call");
    }
    Call call =
        new Call(
            ids.next(),
            Optional.of(called),
            Optional.empty(),
            feature,
            parameters,
            timeout,
            member,
            Optional.empty());
    wire.require(call);
    Duration limit = clock.ofWall(STATUS_LIMIT);
    Duration wait = timeout.compareTo(limit) < 0 ? timeout : limit;
    whenKnown(called, wait, () -> calls.begin(call, roster.readyBoot(called), listener));
    return new Handle(
        call.id(), () -> whenKnown(called, wait, () -> calls.cancel(call.id(), ids.next())));
  }

  /** What the parameter sets of another's feature would cost; the answers are in their order. */
  public void cost(
      String called,
      String feature,
      List<Map<String, Object>> parameterSets,
      Consumer<List<CostAnswer>> answer) {
    CostQuestion question = new CostQuestion(feature, parameterSets, answer);
    call(
        called, ReservedFeature.COST.word(), question.parameters(), CostQuestion.TIMEOUT, question);
  }

  /** Acts once it is known whether the other is there, at the latest when it was waited for. */
  private void whenKnown(String called, Duration wait, Runnable action) {
    clock.perform(
        member,
        () -> {
          if (isDecided(called)) {
            action.run();
            return;
          }
          List<Runnable> actions = awaiting.computeIfAbsent(called, unknown -> new ArrayList<>());
          actions.add(action);
          if (followed.add(called)) {
            subscriptions.subscribe(
                topics.status(called), RetainedMessages.SEND, roster::statusHeard);
          }
          clock.schedule(
              wait,
              member,
              () -> {
                if (actions.remove(action)) {
                  action.run();
                }
              });
        });
  }

  /** Who only begins is neither there nor gone. */
  private boolean isDecided(String called) {
    return roster
        .member(called)
        .filter(other -> other.phase() != MemberStatus.Phase.INIT)
        .isPresent();
  }

  private void goOn(String called) {
    List<Runnable> actions = awaiting.getOrDefault(called, new ArrayList<>());
    List<Runnable> due = List.copyOf(actions);
    awaiting.remove(called);
    actions.clear();
    due.forEach(Runnable::run);
  }

  private final class Presence implements Roster.Watcher {
    @Override
    public void changed(RatsLink.Member other) {
      if (isDecided(other.id())) {
        goOn(other.id());
      }
    }

    @Override
    public boolean asks(String other, String boot, Consumer<Boolean> isAlive) {
      return lifeQuestions.ask(other, boot, isAlive);
    }

    @Override
    public void gone(String other, String boot, String why) {
      calls.memberGone(other, boot, why);
    }

    @Override
    public void returned(String other) {
      calls.resume(other);
    }

    @Override
    public void noticed(String other) {
      // Its status alone counts here.
    }
  }

  /** The connection, on which results for the member's own calls are heard as well. */
  private final class Shared implements Transport {
    /** Within the results that are heard anyhow: filters of one transport must not overlap. */
    private volatile MessageHandler ofItself = message -> {};

    private void resultHeard(Message message) {
      if (message.topic().equals(topics.result(member, member))) {
        ofItself.arrived(message);
      } else {
        calls.resultHeard(message);
      }
    }

    @Override
    public String clientId() {
      return transport.clientId();
    }

    @Override
    public void subscribe(String filter, RetainedMessages retained, MessageHandler handler) {
      if (filter.equals(topics.results(member))) {
        ofItself = handler;
      } else {
        transport.subscribe(filter, retained, handler);
      }
    }

    @Override
    public void subscribeToOthers(String filter, MessageHandler handler) {
      transport.subscribeToOthers(filter, handler);
    }

    @Override
    public void askForRetained(String filter) {
      transport.askForRetained(filter);
    }

    @Override
    public void open(Optional<Will> will, ConnectionListener listener) {
      subscriptions.subscribe(topics.results(member), RetainedMessages.IGNORE, this::resultHeard);
      subscriptions.subscribe(
          topics.progresses(member), RetainedMessages.IGNORE, calls::progressHeard);
      transport.open(
          will,
          new ConnectionListener() {
            @Override
            public void connected() {
              listener.connected();
              clock.perform(member, calls::resume);
            }

            @Override
            public void lost(String reason) {
              listener.lost(reason);
              clock.perform(member, roster::doubtAll);
            }
          });
    }

    @Override
    public void stayAway(Duration pause) {
      transport.stayAway(pause);
    }

    @Override
    public void publish(Publication publication, Completion completion) {
      transport.publish(publication, completion);
    }

    @Override
    public void leave() {
      clock.schedule(Duration.ZERO, member, calls::closeAll);
      clock.schedule(Duration.ZERO, member, lifeQuestions::end);
      transport.leave();
    }

    @Override
    public void close() {
      leave();
      transport.close();
    }

    @Override
    public void die() {
      transport.die();
    }
  }
}
