package org.maestro.rats.transport;

import java.net.URI;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ScheduledFuture;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.ThreadLocalRandom;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A client of an MQTT 5 broker, which reconnects by itself after 0.2 to 2 s. It does one thing at a
 * time, on the thread that asks for it or that Paho tells it on: handlers, listeners and
 * completions are told there. For paced clocks: messages under way in a real broker hold no ticket
 * of a stepped one.
 */
public final class PahoTransport implements Transport {

  private static final Logger LOG = LoggerFactory.getLogger(PahoTransport.class);
  private static final Duration KEEP_ALIVE = Duration.ofSeconds(15);
  private static final long SHORTEST_RETRY_MILLIS = 200;
  private static final long LONGEST_RETRY_MILLIS = 2_000;
  private static final long ATTEMPT_SECONDS = 10;
  private static final long GOODBYE_MILLIS = 2_000;

  private final URI broker;
  private final String clientId;
  private final Optional<Credentials> credentials;
  private final Duration keepAlive;
  private final Admission admission;
  private final ScheduledThreadPoolExecutor timers;
  private final SerialExecutor work = new SerialExecutor();
  private final Events events = new Events();
  private List<PahoSubscription> subscriptions = List.of();
  private final PublishQueue queue = new PublishQueue();
  private final CountDownLatch goodbye = new CountDownLatch(1);
  private Optional<Will> will = Optional.empty();
  private @Nullable ConnectionListener listener;
  private @Nullable PahoConnection connection;

  /** Arrived before the listener was told of the connection. */
  private final List<Message> early = new ArrayList<>();

  private boolean ready;
  private boolean leaving;

  /** A second goodbye would cut the connection before the first is out, as if it had died. */
  private boolean saidGoodbye;

  private boolean toldOfDisplacement;

  /** It waits to be admitted, or is admitted and not ready yet. */
  private boolean queued;

  private boolean admitted;
  private int attempts;
  private long awayUntil = System.nanoTime();
  private long lastSignOfLife = System.nanoTime();

  /**
   * @param broker such as {@code tcp://127.0.0.1:1883}
   */
  public PahoTransport(URI broker, String clientId) {
    this(broker, clientId, new Admission());
  }

  /**
   * As one of many in this process.
   *
   * @param admission the same for all of them
   */
  public PahoTransport(URI broker, String clientId, Admission admission) {
    this(broker, clientId, Optional.empty(), KEEP_ALIVE, admission);
  }

  /**
   * As one that is noticed sooner or later when it freezes: the broker tells of a client's will
   * when it has heard nothing for one and a half times as long.
   *
   * @param keepAlive whole seconds, from 1; usual are 15
   */
  public PahoTransport(URI broker, String clientId, Duration keepAlive) {
    this(broker, clientId, Optional.empty(), keepAlive, new Admission());
  }

  /**
   * To a secured broker, as the user of the credentials.
   *
   * @param broker such as {@code ssl://127.0.0.1:8883}
   */
  public PahoTransport(URI broker, Credentials credentials) {
    this(broker, credentials, new Admission());
  }

  /**
   * The same as one of many in this process.
   *
   * @param admission the same for all of them
   */
  public PahoTransport(URI broker, Credentials credentials, Admission admission) {
    this(broker, credentials.user(), Optional.of(credentials), KEEP_ALIVE, admission);
  }

  private PahoTransport(
      URI broker,
      String clientId,
      Optional<Credentials> credentials,
      Duration keepAlive,
      Admission admission) {
    if (keepAlive.toSeconds() < 1) {
      throw new IllegalArgumentException(
          "A keep-alive is one second or more, not " + keepAlive + ".");
    }
    this.keepAlive = keepAlive;
    this.broker = broker;
    this.clientId = clientId;
    this.credentials = credentials;
    this.admission = admission;
    timers =
        new ScheduledThreadPoolExecutor(
            1,
            runnable -> {
              Thread thread = new Thread(runnable, "rats-transport-" + clientId);
              thread.setDaemon(true);
              return thread;
            },
            (task, stopped) -> LOG.debug("The transport of {} is closed", clientId));
    timers.setRemoveOnCancelPolicy(true);
  }

  @Override
  public String clientId() {
    return clientId;
  }

  @Override
  public void subscribe(String filter, RetainedMessages retained, MessageHandler handler) {
    add(new PahoSubscription(TopicFilter.of(filter), retained, handler, false));
  }

  @Override
  public void subscribeToOthers(String filter, MessageHandler handler) {
    add(new PahoSubscription(TopicFilter.of(filter), RetainedMessages.IGNORE, handler, true));
  }

  private void add(PahoSubscription subscription) {
    perform(
        () -> {
          List<PahoSubscription> more = new ArrayList<>(subscriptions);
          more.add(subscription);
          subscriptions = List.copyOf(more);
          if (ready) {
            PahoConnection current = connected();
            current.subscribe(List.of(subscription), failure -> subscribed(current, failure));
          }
        });
  }

  @Override
  public void askForRetained(String filter) {
    perform(
        () -> {
          List<PahoSubscription> asked =
              subscriptions.stream()
                  .filter(known -> known.retained() == RetainedMessages.SEND)
                  .filter(known -> known.filter().text().equals(filter))
                  .toList();
          if (ready && !leaving && !asked.isEmpty()) {
            PahoConnection current = connected();
            current.subscribe(asked, failure -> subscribed(current, failure));
          }
        });
  }

  @Override
  public void open(Optional<Will> lastWill, ConnectionListener connectionListener) {
    perform(
        () -> {
          will = lastWill;
          listener = connectionListener;
          attempt();
        });
    ScheduledFuture<?> unusedAsTheEndStopsAllTimers =
        timers.scheduleWithFixedDelay(() -> perform(this::showLife), 1, 1, TimeUnit.SECONDS);
  }

  @Override
  public void publish(Publication publication, Completion completion) {
    if (timers.isShutdown()) {
      PublishQueue.refuse(publication, completion, "the transport is closed");
      return;
    }
    perform(
        () -> {
          if (ready && !leaving) {
            queue.add(publication, completion, this::send);
          } else {
            PublishQueue.refuse(publication, completion, "there is no connection to " + broker);
          }
        });
  }

  @Override
  public void stayAway(Duration pause) {
    perform(
        () -> {
          Optional.ofNullable(connection)
              .ifPresent(last -> timers.execute(() -> last.disconnect(last::cut)));
          connection = null;
          drop("it stays away for a while");
          awayUntil = System.nanoTime() + pause.toNanos();
          later(this::attempt, pause.toMillis() + 1);
        });
  }

  @Override
  public void leave() {
    perform(
        () -> {
          leaving = true;
          sayGoodbyeWhenDone();
        });
  }

  @Override
  public void close() {
    leave();
    if (!work.isWithin()) {
      awaitGoodbye();
      end();
    } else {
      ScheduledFuture<?> unusedAsNothingKeepsItFromEnding =
          timers.schedule(this::end, GOODBYE_MILLIS, TimeUnit.MILLISECONDS);
    }
  }

  @Override
  public void die() {
    perform(
        () -> {
          leaving = true;
          goodbye.countDown();
          drop("it died");
        });
    end();
  }

  private void end() {
    perform(() -> drop("the transport is closed"));
    timers.setExecuteExistingDelayedTasksAfterShutdownPolicy(false);
    timers.shutdown();
  }

  private void awaitGoodbye() {
    try {
      if (!goodbye.await(GOODBYE_MILLIS, TimeUnit.MILLISECONDS)) {
        LOG.debug("{} left without goodbye: the broker did not answer in time", clientId);
      }
    } catch (InterruptedException interrupted) {
      Thread.currentThread().interrupt();
    }
  }

  private void sayGoodbyeWhenDone() {
    if (!leaving || !queue.isEmpty() || saidGoodbye) {
      return;
    }
    saidGoodbye = true;
    if (connection == null || !ready) {
      goodbye.countDown();
    } else {
      PahoConnection last = connection;
      // Paho refuses to disconnect on the threads of its callbacks.
      timers.execute(() -> last.disconnect(goodbye::countDown));
    }
  }

  private void attempt() {
    if (mayConnect() && !queued) {
      queued = true;
      admission.enter(() -> perform(this::connect));
    }
  }

  private boolean mayConnect() {
    return !leaving && connection == null && System.nanoTime() - awayUntil >= 0;
  }

  private void connect() {
    queued = false;
    admitted = true;
    if (!mayConnect()) {
      makeRoom();
      return;
    }
    PahoConnection tried =
        new PahoConnection(broker, clientId, keepAlive, will, credentials, events);
    connection = tried;
    tried.connect();
    later(() -> giveUp(tried), ATTEMPT_SECONDS * 1_000);
  }

  private void makeRoom() {
    if (admitted) {
      admitted = false;
      admission.leave();
    }
  }

  private void giveUp(PahoConnection tried) {
    if (tried == connection && !ready) {
      lost("the broker did not answer within " + ATTEMPT_SECONDS + " s");
    }
  }

  private void established(PahoConnection source, int receiveMaximum) {
    queue.bound(receiveMaximum);
    if (subscriptions.isEmpty()) {
      subscribed(source, Optional.empty());
    } else {
      source.subscribe(subscriptions, failure -> subscribed(source, failure));
    }
  }

  private void subscribed(PahoConnection source, Optional<String> failure) {
    perform(
        () -> {
          if (source != connection) {
            return;
          }
          if (failure.isPresent()) {
            lost("a subscription failed: " + failure.get());
          } else if (!ready) {
            ready = true;
            attempts = 0;
            makeRoom();
            listener().connected();
            List<Message> waiting = List.copyOf(early);
            early.clear();
            waiting.forEach(this::dispatch);
          }
        });
  }

  private void lost(String reason) {
    drop("the connection was lost: " + reason);
    if (leaving) {
      goodbye.countDown();
      return;
    }
    long ceiling =
        Math.min(LONGEST_RETRY_MILLIS, (2 * SHORTEST_RETRY_MILLIS) << Math.min(attempts++, 4));
    long delay = ThreadLocalRandom.current().nextLong(SHORTEST_RETRY_MILLIS, ceiling + 1);
    later(this::attempt, delay);
    LOG.debug(
        "{} has no connection to {} ({}); next try in {} ms", clientId, broker, reason, delay);
    listener().lost(reason);
  }

  /** The two may displace each other for hours, several times a second: it is said once. */
  private void tellOfDisplacement() {
    if (!toldOfDisplacement) {
      toldOfDisplacement = true;
      LOG.warn(
          "Another client connects to {} as {} too, so that the broker drops this one; give it a"
              + " client id of its own.",
          broker,
          clientId);
    }
  }

  private void drop(String reason) {
    if (connection != null) {
      connection.cut();
      connection = null;
    }
    ready = false;
    makeRoom();
    early.clear();
    queue.failAll(reason);
  }

  private void send(PublishQueue.Entry entry) {
    connected()
        .publish(
            entry.publication(),
            failure ->
                perform(
                    () -> {
                      queue.completed(entry, failure, this::send);
                      sayGoodbyeWhenDone();
                    }));
  }

  /** Of the one connection, while this is ready. */
  private PahoConnection connected() {
    return Objects.requireNonNull(connection);
  }

  /** There from the opening on; nothing connects before. */
  private ConnectionListener listener() {
    return Objects.requireNonNull(listener);
  }

  private void showLife() {
    if (!reconnectedAfterStall()) {
      lastSignOfLife = System.nanoTime();
    }
  }

  /** What arrived while this loop stood still may be stale, and must not be acted on. */
  private boolean reconnectedAfterStall() {
    boolean stalled =
        System.nanoTime() - lastSignOfLife > keepAlive.multipliedBy(3).dividedBy(2).toNanos();
    if (stalled) {
      lastSignOfLife = System.nanoTime();
      if (connection != null) {
        lost("this process stood still for too long");
      }
    }
    return stalled;
  }

  private void dispatch(Message message) {
    if (reconnectedAfterStall()) {
      return;
    }
    for (PahoSubscription subscription : subscriptions) {
      if (subscription.filter().matches(message.topic())) {
        subscription.handler().arrived(message);
      }
    }
  }

  private void perform(Runnable action) {
    work.run(() -> guarded(action));
  }

  private void later(Runnable action, long millis) {
    ScheduledFuture<?> unusedAsActionsLookWhetherTheyAreLate =
        timers.schedule(() -> perform(action), millis, TimeUnit.MILLISECONDS);
  }

  private void guarded(Runnable action) {
    try {
      action.run();
    } catch (RuntimeException failure) {
      LOG.error(
          "A listener of the transport of {} failed; the transport goes on", clientId, failure);
    }
  }

  private final class Events implements PahoConnection.Events {
    @Override
    public void established(PahoConnection source, int receiveMaximum) {
      performFor(source, () -> PahoTransport.this.established(source, receiveMaximum));
    }

    @Override
    public void ended(PahoConnection source, String reason) {
      performFor(source, () -> lost(reason));
    }

    @Override
    public void displaced(PahoConnection source) {
      perform(PahoTransport.this::tellOfDisplacement);
      ended(source, "another client connected under its client id");
    }

    @Override
    public void arrived(PahoConnection source, Message message) {
      performFor(
          source,
          () -> {
            if (ready) {
              dispatch(message);
            } else {
              early.add(message);
            }
          });
    }

    private void performFor(PahoConnection source, Runnable action) {
      perform(
          () -> {
            if (source == connection) {
              action.run();
            }
          });
    }
  }
}
