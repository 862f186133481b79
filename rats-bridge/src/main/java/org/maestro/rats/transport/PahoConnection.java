package org.maestro.rats.transport;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.net.URI;
import java.security.GeneralSecurityException;
import java.security.cert.CertificateException;
import java.security.cert.CertificateExpiredException;
import java.security.cert.CertificateNotYetValidException;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import org.eclipse.paho.mqttv5.client.IMqttToken;
import org.eclipse.paho.mqttv5.client.MqttActionListener;
import org.eclipse.paho.mqttv5.client.MqttAsyncClient;
import org.eclipse.paho.mqttv5.client.MqttCallback;
import org.eclipse.paho.mqttv5.client.MqttConnectionOptions;
import org.eclipse.paho.mqttv5.client.MqttDisconnectResponse;
import org.eclipse.paho.mqttv5.client.persist.MemoryPersistence;
import org.eclipse.paho.mqttv5.common.MqttException;
import org.eclipse.paho.mqttv5.common.MqttMessage;
import org.eclipse.paho.mqttv5.common.MqttSubscription;
import org.eclipse.paho.mqttv5.common.packet.MqttProperties;

/**
 * One connection of {@link PahoTransport}, used once: a new attempt gets a new Paho client, so that
 * nothing of the old session lingers. Paho's callbacks arrive on its own threads and are handed on
 * at once.
 */
final class PahoConnection implements MqttCallback {

  /**
   * Paho's sender, receiver, callback and connect tasks each keep a thread; one more for its pings.
   */
  private static final int PAHO_THREADS = 5;

  private static final int REFUSED = 0x80;
  private static final int SESSION_TAKEN_OVER = 0x8E;

  /** What MQTT 5 means when the broker does not say it. */
  private static final int UNSAID_RECEIVE_MAXIMUM = 65_535;

  private static final int CONNECT_SECONDS = 5;

  /** The listener for a connection's events, told on Paho's threads. */
  interface Events {
    /**
     * @param receiveMaximum so many publishes may be under way, as the broker says
     */
    void established(PahoConnection connection, int receiveMaximum);

    void ended(PahoConnection connection, String reason);

    /**
     * It ended since another client connected under the same client id, as brokers say that send
     * MQTT 5's reason code for it; what was under way may have told before that it ended.
     */
    default void displaced(PahoConnection connection) {
      ended(connection, "another client connected under its client id");
    }

    void arrived(PahoConnection connection, Message message);
  }

  private final MqttAsyncClient client;
  private final MqttConnectionOptions options = new MqttConnectionOptions();
  private final CuttableSockets sockets;
  private final ScheduledThreadPoolExecutor threads;
  private final Events events;

  PahoConnection(
      URI broker,
      String clientId,
      Duration keepAlive,
      Optional<Transport.Will> will,
      Optional<Credentials> credentials,
      Events events) {
    this.events = events;
    this.sockets = new CuttableSockets(credentials.map(Credentials::tls));
    threads =
        new ScheduledThreadPoolExecutor(
            PAHO_THREADS,
            runnable -> {
              Thread thread = new Thread(runnable, "rats-paho-" + clientId);
              thread.setDaemon(true);
              return thread;
            });
    threads.setExecuteExistingDelayedTasksAfterShutdownPolicy(false);
    try {
      client =
          new MqttAsyncClient(address(broker), clientId, new MemoryPersistence(), null, threads);
    } catch (MqttException unusable) {
      throw new IllegalArgumentException(
          "The broker's address " + broker + " cannot be used: " + reason(unusable), unusable);
    }
    client.setCallback(this);
    options.setCleanStart(true);
    options.setAutomaticReconnect(false);
    options.setKeepAliveInterval((int) keepAlive.toSeconds());
    options.setConnectionTimeout(CONNECT_SECONDS);
    options.setUseSubscriptionIdentifiers(false);
    options.setSocketFactory(sockets);
    credentials.ifPresent(this::identify);
    will.ifPresent(
        last -> options.setWill(last.topic(), new MqttMessage(last.payload(), 1, true, null)));
  }

  /** With a certificate alone, the broker takes the name from there. */
  private void identify(Credentials credentials) {
    credentials
        .password()
        .ifPresent(
            password -> {
              options.setUserName(credentials.user());
              options.setPassword(password.getBytes(UTF_8));
            });
  }

  /** TLS is the sockets' business, so that Paho sees a plain connection. */
  private static String address(URI broker) {
    return "tcp://" + broker.getHost() + ":" + broker.getPort();
  }

  void connect() {
    MqttActionListener told =
        listener(
            (token, failure) ->
                failure.ifPresentOrElse(
                    reason -> events.ended(this, reason),
                    () -> events.established(this, receiveMaximum(token))));
    start(() -> client.connect(options, null, told), failure -> events.ended(this, failure));
  }

  private static int receiveMaximum(IMqttToken connected) {
    return Optional.ofNullable(connected.getResponseProperties())
        .map(MqttProperties::getReceiveMaximum)
        .orElse(UNSAID_RECEIVE_MAXIMUM);
  }

  /** All in one packet; the completion is told on a Paho thread, or at once when refused. */
  void subscribe(List<PahoSubscription> subscriptions, Consumer<Optional<String>> completion) {
    MqttSubscription[] wire =
        subscriptions.stream().map(PahoSubscription::wire).toArray(MqttSubscription[]::new);
    start(
        () -> client.subscribe(wire, null, listener(completion), new MqttProperties()),
        failure -> completion.accept(Optional.of(failure)));
  }

  /** The completion is told on a Paho thread, or at once when refused. */
  void publish(Publication publication, Consumer<Optional<String>> completion) {
    MqttProperties properties = new MqttProperties();
    publication
        .expiry()
        .ifPresent(
            expiry ->
                properties.setMessageExpiryInterval(Math.max(1, (expiry.toMillis() + 999) / 1000)));
    int quality = publication.quality() == Publication.Quality.AT_LEAST_ONCE ? 1 : 0;
    MqttMessage message =
        new MqttMessage(publication.payload(), quality, publication.retained(), properties);
    start(
        () -> client.publish(publication.topic(), message, null, listener(completion)),
        failure -> completion.accept(Optional.of(failure)));
  }

  /**
   * Sends DISCONNECT; the completion is told on a Paho thread, or at once when that is not
   * possible.
   */
  void disconnect(Runnable completion) {
    start(
        () -> client.disconnect(0, null, listener(ignored -> completion.run()), 0, null),
        failure -> completion.run());
  }

  /** Cuts the connection, and lets its threads end. */
  void cut() {
    sockets.cut();
    threads.shutdown();
  }

  private void start(PahoCall call, Consumer<String> refused) {
    try {
      call.run();
    } catch (MqttException exception) {
      refused.accept(reason(exception));
    }
  }

  private static MqttActionListener listener(Consumer<Optional<String>> completion) {
    return listener((token, failure) -> completion.accept(failure));
  }

  private static MqttActionListener listener(BiConsumer<IMqttToken, Optional<String>> completion) {
    return new MqttActionListener() {
      @Override
      public void onSuccess(IMqttToken token) {
        int[] codes = token.getReasonCodes();
        if (codes != null && Arrays.stream(codes).anyMatch(code -> code >= REFUSED)) {
          String reason = "the broker refused it with reason code " + Arrays.toString(codes);
          completion.accept(token, Optional.of(reason));
        } else {
          completion.accept(token, Optional.empty());
        }
      }

      @Override
      public void onFailure(IMqttToken token, Throwable cause) {
        completion.accept(token, Optional.of(reason(cause)));
      }
    };
  }

  private static String reason(Throwable cause) {
    Throwable root = cause;
    while (root.getCause() != null && root.getCause() != root) {
      root = root.getCause();
    }
    String message =
        root.getMessage() == null ? root.getClass().getSimpleName() : root.getMessage();
    if (root instanceof CertificateExpiredException
        || root instanceof CertificateNotYetValidException) {
      return "its certificate is out of date (" + message + ")";
    }
    if (root instanceof CertificateException) {
      return "its certificate is of another name (" + message + ")";
    }
    return root instanceof GeneralSecurityException
        ? "its certificate is not of the site's CA (" + message + ")"
        : message;
  }

  @Override
  public void disconnected(MqttDisconnectResponse response) {
    if (response.getReturnCode() == SESSION_TAKEN_OVER) {
      events.displaced(this);
      return;
    }
    String reason =
        response.getException() == null
            ? "the broker disconnected it, reason code " + response.getReturnCode()
            : reason(response.getException());
    events.ended(this, reason);
  }

  @Override
  public void messageArrived(String topic, MqttMessage message) {
    Optional<Duration> expiry =
        Optional.ofNullable(message.getProperties())
            .map(MqttProperties::getMessageExpiryInterval)
            .map(Duration::ofSeconds);
    events.arrived(this, new Message(topic, message.getPayload(), message.isRetained(), expiry));
  }

  @Override
  public void mqttErrorOccurred(MqttException exception) {
    events.ended(this, reason(exception));
  }

  @Override
  public void deliveryComplete(IMqttToken token) {
    // The action listener of each publish is told already.
  }

  @Override
  public void connectComplete(boolean reconnect, String serverUri) {
    // The action listener of the connect is told already.
  }

  @Override
  public void authPacketArrived(int reasonCode, MqttProperties properties) {
    // Extended authentication is not used.
  }

  private interface PahoCall {
    void run() throws MqttException;
  }
}
