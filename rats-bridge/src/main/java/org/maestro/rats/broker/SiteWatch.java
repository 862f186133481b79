package org.maestro.rats.broker;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.cert.CertificateFactory;
import java.security.cert.X509CRL;
import java.security.cert.X509Certificate;
import java.time.Duration;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Properties;
import java.util.Set;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.ScheduledFuture;
import java.util.concurrent.TimeUnit;
import org.apache.activemq.artemis.api.core.ActiveMQException;
import org.apache.activemq.artemis.core.remoting.impl.netty.NettyAcceptor;
import org.apache.activemq.artemis.core.security.Role;
import org.apache.activemq.artemis.core.security.impl.SecurityStoreImpl;
import org.apache.activemq.artemis.core.server.ActiveMQServer;
import org.apache.activemq.artemis.spi.core.protocol.RemotingConnection;
import org.apache.activemq.artemis.spi.core.remoting.Acceptor;
import org.apache.activemq.artemis.utils.CertificateUtil;
import org.maestro.rats.security.WatchedFiles;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Has a secured broker that runs go by its site's files as they are now: who has been added may
 * come, who has been taken out is cut off, and the broker shows the certificate that it has been
 * given. Passwords and roles are read again by Artemis itself.
 */
final class SiteWatch implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(SiteWatch.class);
  private static final Duration LOOKED_EVERY = Duration.ofMillis(500);
  private static final Duration LONGEST_LOOK = Duration.ofSeconds(10);

  private final ActiveMQServer server;
  private final Path artemis;
  private final Path revoked;
  private final WatchedFiles users;
  private final WatchedFiles certificates;
  private final ScheduledExecutorService looking =
      Executors.newSingleThreadScheduledExecutor(
          work -> {
            Thread thread = new Thread(work, "maestro-broker-site");
            thread.setDaemon(true);
            return thread;
          });

  private SiteWatch(ActiveMQServer server, Path artemis) {
    this.server = server;
    this.artemis = artemis;
    this.revoked = artemis.resolveSibling("ca").resolve("revoked.pem");
    this.users =
        new WatchedFiles(
            List.of(
                artemis.resolve("users.properties"),
                artemis.resolve("roles.properties"),
                artemis.resolve("certificates.properties"),
                artemis.resolve("broker.xml")));
    this.certificates =
        new WatchedFiles(List.of(revoked, artemis.resolveSibling("broker").resolve("broker.p12")));
  }

  /**
   * @param artemis the directory with the site's broker.xml and login.config
   */
  static SiteWatch begin(ActiveMQServer server, Path artemis) {
    SiteWatch watch = new SiteWatch(server, artemis);
    ScheduledFuture<?> unusedAsClosingEndsIt =
        watch.looking.scheduleWithFixedDelay(
            watch::look, LOOKED_EVERY.toMillis(), LOOKED_EVERY.toMillis(), TimeUnit.MILLISECONDS);
    return watch;
  }

  private void look() {
    try {
      boolean otherUsers = users.haveChanged();
      boolean otherCertificates = certificates.haveChanged();
      if (otherUsers) {
        Set<Map.Entry<String, Set<Role>>> rights =
            SecuredConfiguration.read(artemis).rights().entrySet();
        server.getSecurityRepository().swap(rights);
      }
      if (otherCertificates) {
        for (Acceptor acceptor : server.getRemotingService().getAcceptors().values()) {
          ((NettyAcceptor) acceptor).reload();
        }
      }
      if (otherUsers || otherCertificates) {
        forgetWhoWasLetIn();
        cutOff();
      }
    } catch (IOException | GeneralSecurityException | RuntimeException unusable) {
      // What is thrown here would end the looking for good, and nobody would be cut off any more.
      LOG.error("The broker goes on as before: {}", unusable.getMessage());
    }
  }

  private void forgetWhoWasLetIn() {
    if (server.getSecurityStore() instanceof SecurityStoreImpl store) {
      store.invalidateAuthenticationCache();
      store.invalidateAuthorizationCache();
    }
  }

  private void cutOff() throws IOException, GeneralSecurityException {
    Properties known = new Properties();
    known.load(new ByteArrayInputStream(Files.readAllBytes(artemis.resolve("users.properties"))));
    X509CRL list =
        (X509CRL)
            CertificateFactory.getInstance("X.509")
                .generateCRL(new ByteArrayInputStream(Files.readAllBytes(revoked)));
    for (RemotingConnection connection :
        new HashSet<>(server.getRemotingService().getConnections())) {
      String user = connection.getClientID();
      if (user != null && (!known.containsKey(user) || isRevoked(connection, list))) {
        LOG.warn("The user {} is no longer one of the site: its connection ends", user);
        connection.fail(new ActiveMQException("no longer a user of the site"));
      }
    }
  }

  private static boolean isRevoked(RemotingConnection connection, X509CRL list) {
    X509Certificate[] shown = CertificateUtil.getCertsFromConnection(connection);
    return shown != null && shown.length > 0 && list.isRevoked(shown[0]);
  }

  /** Waits until it is done with what it is at: the broker is not to be changed while it stops. */
  @Override
  public void close() {
    looking.shutdown();
    try {
      if (!looking.awaitTermination(LONGEST_LOOK.toMillis(), TimeUnit.MILLISECONDS)) {
        LOG.warn("The broker ends while it takes up what has changed");
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
