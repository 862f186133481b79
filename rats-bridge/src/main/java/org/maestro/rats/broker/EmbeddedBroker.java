package org.maestro.rats.broker;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.URI;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.IntFunction;
import org.apache.activemq.artemis.api.core.SimpleString;
import org.apache.activemq.artemis.api.core.TransportConfiguration;
import org.apache.activemq.artemis.core.config.Configuration;
import org.apache.activemq.artemis.core.config.impl.ConfigurationImpl;
import org.apache.activemq.artemis.core.remoting.impl.netty.NettyAcceptorFactory;
import org.apache.activemq.artemis.core.remoting.impl.netty.TransportConstants;
import org.apache.activemq.artemis.core.server.embedded.EmbeddedActiveMQ;
import org.apache.activemq.artemis.core.settings.impl.AddressSettings;

/**
 * An MQTT 5 broker in this process, on loopback, without a journal: sessions are clean, and members
 * publish what is retained again. Any thread may use it. After {@link #close} no thread and no file
 * of it is left.
 */
public final class EmbeddedBroker implements AutoCloseable {
  /** By itself Artemis looks every two seconds only, however short a client's keep-alive is. */
  private static final long FROZEN_LOOKED_FOR_EVERY_MILLIS = 200;

  /**
   * A controller's own calls, which it does not want to hear, stay in Artemis until somebody looks
   * whether they have expired; by itself Artemis does so every thirty seconds.
   */
  private static final long EXPIRED_LOOKED_FOR_EVERY_MILLIS = 2_000;

  private static final String HOST = "127.0.0.1";
  private static final int MOST_ATTEMPTS = 10;

  private final EmbeddedActiveMQ server;
  private final URI uri;
  private final AutoCloseable beside;

  /**
   * @param beside ends before the broker does
   */
  private EmbeddedBroker(EmbeddedActiveMQ server, URI uri, AutoCloseable beside) {
    this.server = server;
    this.uri = uri;
    this.beside = beside;
  }

  /** Starts on a free port. */
  public static EmbeddedBroker start() {
    return start(0);
  }

  /**
   * @param port 0 for a free one
   * @throws BrokerStartException when the port is taken, or the broker does not start
   */
  public static EmbeddedBroker start(int port) {
    return started(
        port,
        chosen -> {
          EmbeddedActiveMQ server = new EmbeddedActiveMQ();
          start(server, configuration(chosen), chosen);
          return new EmbeddedBroker(server, uri("tcp", chosen), () -> {});
        });
  }

  /**
   * Starts for a secured site: over TLS, for the site's users, who may do what its files allow.
   * What changes in the files is taken up within a second or two.
   *
   * @param files the directory with the site's broker.xml and login.config
   * @param port 0 for a free one; what broker.xml says of it is for an Artemis of its own
   * @throws BrokerStartException when the port is taken, or the broker does not start
   */
  public static EmbeddedBroker startSecured(Path files, int port) {
    return started(
        port,
        chosen -> {
          SecuredConfiguration secured = SecuredConfiguration.read(files);
          EmbeddedActiveMQ server = new EmbeddedActiveMQ();
          server.setSecurityManager(secured.securityManager());
          start(server, secured.configuration(HOST, chosen), chosen);
          return new EmbeddedBroker(
              server, uri("ssl", chosen), SiteWatch.begin(server.getActiveMQServer(), files));
        });
  }

  /** A port that was free may be taken by somebody else just before the broker has it. */
  private static EmbeddedBroker started(int port, IntFunction<EmbeddedBroker> starting) {
    for (int attempt = 1; ; attempt++) {
      int chosen = usable(port);
      try {
        return starting.apply(chosen);
      } catch (PortTakenException taken) {
        if (port != 0 || attempt == MOST_ATTEMPTS) {
          throw new BrokerStartException(chosen, taken);
        }
      }
    }
  }

  /** Somebody else was quicker. */
  private static final class PortTakenException extends RuntimeException {
    private static final long serialVersionUID = 1L;
  }

  private static URI uri(String scheme, int port) {
    return URI.create(scheme + "://" + HOST + ":" + port);
  }

  private static void start(EmbeddedActiveMQ server, Configuration configuration, int chosen) {
    server.setConfiguration(configuration);
    try {
      server.start();
    } catch (Exception failure) {
      stop(server);
      throw new BrokerStartException(chosen, failure);
    }
    if (!server.getActiveMQServer().getRemotingService().isStarted()) {
      stop(server);
      throw new BrokerStartException(chosen);
    }
    if (!listens(server, configuration)) {
      stop(server);
      throw new PortTakenException();
    }
  }

  /** Artemis only logs that it has not got its port, and goes on. */
  private static boolean listens(EmbeddedActiveMQ server, Configuration configuration) {
    return configuration.getAcceptorConfigurations().stream()
        .map(
            acceptor ->
                server.getActiveMQServer().getRemotingService().getAcceptor(acceptor.getName()))
        .allMatch(acceptor -> acceptor != null && acceptor.getActualPort() > 0);
  }

  /** What clients connect to. */
  public URI uri() {
    return uri;
  }

  /** Messages that it has, for whomever. */
  long waiting() {
    return server.getActiveMQServer().getTotalMessageCount();
  }

  @Override
  public void close() {
    try {
      beside.close();
    } catch (Exception failure) {
      throw new IllegalStateException("The embedded broker could not be let alone", failure);
    } finally {
      stop(server);
    }
  }

  private static void stop(EmbeddedActiveMQ server) {
    try {
      server.stop();
    } catch (Exception failure) {
      throw new IllegalStateException("The embedded broker did not stop cleanly", failure);
    }
  }

  private static int usable(int port) {
    try (ServerSocket probe = new ServerSocket()) {
      probe.setReuseAddress(true);
      probe.bind(new InetSocketAddress(InetAddress.getAllByName(HOST)[0], port));
      return probe.getLocalPort();
    } catch (IOException taken) {
      throw new BrokerStartException(port, taken);
    }
  }

  private static ConfigurationImpl configuration(int port) {
    Map<String, Object> acceptor = new LinkedHashMap<>();
    acceptor.put(TransportConstants.HOST_PROP_NAME, HOST);
    acceptor.put(TransportConstants.PORT_PROP_NAME, port);
    acceptor.put(TransportConstants.PROTOCOLS_PROP_NAME, "MQTT");
    acceptor.put(TransportConstants.TCP_NODELAY_PROPNAME, true);
    ConfigurationImpl configuration = new ConfigurationImpl();
    configuration.setPersistenceEnabled(false);
    configuration.setSecurityEnabled(false);
    configuration.setJMXManagementEnabled(false);
    configuration.setMessageCounterEnabled(false);
    configuration.setMaxDiskUsage(-1);
    configuration.setConnectionTtlCheckInterval(FROZEN_LOOKED_FOR_EVERY_MILLIS);
    configuration.setMessageExpiryScanPeriod(EXPIRED_LOOKED_FOR_EVERY_MILLIS);
    configuration.setName("rats-" + port);
    configuration.registerBrokerPlugin(new NoRetainedCalls());
    configuration.addAddressSetting("#", quietAboutDeadLetters());
    configuration.addAcceptorConfiguration(
        new TransportConfiguration(NettyAcceptorFactory.class.getName(), acceptor, "mqtt"));
    return configuration;
  }

  /**
   * Addresses without queues: what cannot be delivered is dropped, and the broker does not warn of
   * each topic.
   */
  private static AddressSettings quietAboutDeadLetters() {
    return new AddressSettings()
        .setDeadLetterAddress(SimpleString.of("dead-letters"))
        .setExpiryAddress(SimpleString.of("expired"));
  }
}
