package org.maestro.rats.transport;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ScheduledFuture;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import org.maestro.rats.transport.Transport.Completion;
import org.maestro.rats.transport.Transport.MessageHandler;
import org.maestro.rats.transport.Transport.RetainedMessages;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * One connection that many clients of this process share: to a broker, a thousand connections with
 * some subscriptions each are far more work than one that hears everything. Each client behaves as
 * one with a connection of its own. The will of one that dies is published from here, so wills are
 * lost when the whole process dies: it is for processes whose broker dies with them. Any thread.
 */
public final class SharedConnection implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(SharedConnection.class);

  private final Transport connection;
  private final TopicFilter heard;
  private final List<TopicFilter> retained;
  private final SerialExecutor work = new SerialExecutor();
  private final ScheduledThreadPoolExecutor timers;

  private final Set<SharedClient> clients = new LinkedHashSet<>();
  private final Map<String, List<Interest>> ofTopics = new HashMap<>();
  private final Map<TopicFilter, List<Interest>> ofWildcards = new LinkedHashMap<>();
  private final KeptMessages kept = new KeptMessages();
  private final OwnEchoes<SharedClient> echoes = new OwnEchoes<>();
  private boolean opened;
  private boolean connected;

  /** A client's subscription. */
  record Interest(
      SharedClient client,
      TopicFilter filter,
      RetainedMessages retained,
      MessageHandler handler,
      boolean ofOthers) {}

  /**
   * @param connection not open yet, and without subscriptions
   * @param heard an MQTT topic filter for all that clients may hear of: {@code rats/1/home/#}
   * @param retained filters of topics on which all that is published is retained: who hears of many
   *     topics at once is not told by every broker that what was just published is (seen with
   *     Artemis)
   */
  public SharedConnection(Transport connection, String heard, List<String> retained) {
    this.connection = connection;
    this.heard = TopicFilter.of(heard);
    this.retained = retained.stream().map(TopicFilter::of).toList();
    connection.subscribe(heard, RetainedMessages.SEND, message -> perform(() -> arrived(message)));
    timers =
        new ScheduledThreadPoolExecutor(
            1,
            runnable -> {
              Thread thread = new Thread(runnable, "rats-shared-" + connection.clientId());
              thread.setDaemon(true);
              return thread;
            },
            (task, stopped) -> LOG.debug("The shared connection is closed"));
  }

  /** A client that is not open yet. */
  public Transport client(String id) {
    return new SharedClient(id, this);
  }

  /** Says goodbye for all clients that are left, and closes the connection. */
  @Override
  public void close() {
    perform(() -> new ArrayList<>(clients).forEach(this::leave));
    connection.close();
    timers.shutdownNow();
  }

  /**
   * @throws IllegalArgumentException when this connection does not hear of what the filter asks for
   */
  void subscribe(Interest interest) {
    if (!interest.filter().text().startsWith(heard.before())) {
      throw new IllegalArgumentException(
          "'%s' is not among what this connection hears, '%s'."
              .formatted(interest.filter().text(), heard.text()));
    }
    perform(
        () -> {
          if (!interest.client().isGone()) {
            interestsOf(interest.filter()).add(interest);
            interest.client().interests().add(interest);
            tellKept(interest);
          }
        });
  }

  private List<Interest> interestsOf(TopicFilter filter) {
    return filter.hasWildcard()
        ? ofWildcards.computeIfAbsent(filter, absent -> new ArrayList<>())
        : ofTopics.computeIfAbsent(filter.text(), absent -> new ArrayList<>());
  }

  void tellKeptAgain(SharedClient client, String filter) {
    perform(
        () ->
            client.interests().stream()
                .filter(interest -> interest.filter().text().equals(filter))
                .forEach(this::tellKept));
  }

  private void tellKept(Interest interest) {
    if (interest.client().isConnected() && interest.retained() == RetainedMessages.SEND) {
      kept.matching(interest.filter()).forEach(message -> tell(interest, message));
    }
  }

  void open(SharedClient client) {
    perform(
        () -> {
          if (client.isGone()) {
            return;
          }
          clients.add(client);
          if (!opened) {
            opened = true;
            connection.open(Optional.empty(), new Listener());
          } else if (connected) {
            join(client);
          }
        });
  }

  private void join(SharedClient client) {
    client.connected();
    guarded(client.listener()::connected);
    client.interests().forEach(this::tellKept);
  }

  void publish(SharedClient client, Publication publication, Completion completion) {
    perform(
        () -> {
          if (!client.isConnected()) {
            guarded(
                () ->
                    PublishQueue.refuse(
                        publication,
                        completion,
                        client.isGone() ? "the transport is closed" : "there is no connection"));
            return;
          }
          if (client.wantsOnlyOthersOf(publication.topic())) {
            echoes.expect(client, publication);
          }
          connection.publish(publication, completion);
        });
  }

  /**
   * @param pause wall time
   */
  void stayAway(SharedClient client, Duration pause) {
    perform(
        () -> {
          client.away();
          ScheduledFuture<?> unusedAsTheEndStopsAllTimers =
              timers.schedule(
                  () -> perform(() -> comeBack(client)), pause.toNanos(), TimeUnit.NANOSECONDS);
        });
  }

  private void comeBack(SharedClient client) {
    if (client.isAway() && !client.isGone()) {
      client.back();
      if (connected) {
        join(client);
      }
    }
  }

  /** Its will is told as a broker would tell it. */
  void die(SharedClient client) {
    perform(
        () -> {
          if (client.isConnected()) {
            client
                .will()
                .ifPresent(
                    will ->
                        connection.publish(
                            Publication.retained(will.topic(), will.payload()),
                            failure ->
                                failure.ifPresent(cause -> LOG.debug("{}", cause.getMessage()))));
          }
          leave(client);
        });
  }

  /**
   * @param done told when nothing is told to the client any more
   */
  void leave(SharedClient client, Runnable done) {
    perform(
        () -> {
          leave(client);
          done.run();
        });
  }

  private void leave(SharedClient client) {
    client.gone();
    clients.remove(client);
    for (Interest interest : client.interests()) {
      List<Interest> same = interestsOf(interest.filter());
      same.remove(interest);
      if (same.isEmpty()) {
        ofTopics.remove(interest.filter().text());
        ofWildcards.remove(interest.filter());
      }
    }
    client.interests().clear();
  }

  boolean isWithin() {
    return work.isWithin();
  }

  private void arrived(Message told) {
    Message message =
        new Message(
            told.topic(),
            told.payload(),
            told.retained() || retained.stream().anyMatch(f -> f.matches(told.topic())),
            told.remainingExpiry());
    Optional<SharedClient> publisher = echoes.publisher(message);
    boolean isSentAgain = kept.isSentAgain(message);
    List<Interest> concerned = new ArrayList<>(ofTopics.getOrDefault(message.topic(), List.of()));
    ofWildcards.forEach(
        (filter, interests) -> {
          if (filter.matches(message.topic())) {
            concerned.addAll(interests);
          }
        });
    for (Interest interest : concerned) {
      boolean isOwn =
          interest.ofOthers() && publisher.filter(interest.client()::equals).isPresent();
      boolean isWanted = !isSentAgain || interest.retained() == RetainedMessages.SEND;
      if (interest.client().isConnected() && isWanted && !isOwn) {
        tell(interest, message);
      }
    }
  }

  private static void tell(Interest interest, Message message) {
    guarded(() -> interest.handler().arrived(message));
  }

  private void perform(Runnable action) {
    work.run(() -> guarded(action));
  }

  private static void guarded(Runnable action) {
    try {
      action.run();
    } catch (RuntimeException failure) {
      LOG.error("A client of a shared connection failed; the others go on", failure);
    }
  }

  private final class Listener implements Transport.ConnectionListener {
    @Override
    public void connected() {
      perform(
          () -> {
            connected = true;
            List.copyOf(clients).stream()
                .filter(client -> !client.isAway())
                .forEach(SharedConnection.this::join);
          });
    }

    @Override
    public void lost(String reason) {
      perform(
          () -> {
            connected = false;
            kept.connectionLost();
            echoes.connectionLost();
            for (SharedClient client : List.copyOf(clients)) {
              if (!client.isAway()) {
                client.disconnected();
                guarded(() -> client.listener().lost(reason));
              }
            }
          });
    }
  }
}
