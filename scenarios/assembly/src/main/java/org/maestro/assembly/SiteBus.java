package org.maestro.assembly;

import java.net.URI;
import java.time.Duration;
import java.util.Optional;
import java.util.function.Function;
import org.maestro.rats.broker.EmbeddedBroker;
import org.maestro.rats.link.SiteKind;
import org.maestro.rats.member.CallPolicy;
import org.maestro.rats.protocol.Topics;
import org.maestro.rats.security.SiteSecurity;
import org.maestro.rats.transport.Admission;
import org.maestro.rats.transport.ConnectionTester;
import org.maestro.rats.transport.PahoTransport;
import org.maestro.rats.transport.SharedConnection;
import org.maestro.rats.transport.Transport;

/**
 * The access of a process to a site over MQTT, open or secured. On a secured one everybody connects
 * under its own name; on an open one the site's name is put before it, so that several sites can
 * share a broker.
 */
public final class SiteBus {
  private static final Duration ANSWER_WITHIN = Duration.ofSeconds(10);
  private static final String OF_SITE =
      "it has to run with the files that ./maestro secure wrote for it";
  private static final String OPEN =
      "without --security DIR only a broker that lets everybody in will do";

  private final URI broker;
  private final String site;
  private final Optional<SiteSecurity> security;
  private final Admission admission = new Admission();

  /**
   * @throws SiteException when the security files are of another site, or the broker's scheme is
   *     not that of a secured or open site
   */
  public SiteBus(URI broker, String site, Optional<SiteSecurity> security) {
    this.broker = broker;
    this.site = site;
    this.security = security;
    security.ifPresent(files -> requireOf(site, files));
    boolean tls = "ssl".equals(broker.getScheme());
    if (tls != security.isPresent()) {
      throw new SiteException(
          tls
              ? "The broker %s is that of a secured site; name its files with --security DIR."
                  .formatted(broker)
              : "The broker %s takes no TLS; a secured site needs ssl://HOST:PORT."
                  .formatted(broker));
    }
  }

  /** A broker of our own in this process. */
  static EmbeddedBroker ownBroker(SiteSettings settings) {
    return settings
        .security()
        .map(files -> EmbeddedBroker.startSecured(files.artemis(), settings.brokerPort()))
        .orElseGet(() -> EmbeddedBroker.start(settings.brokerPort()));
  }

  /**
   * Makes sure that the broker lets a user of this site in, before anything begins.
   *
   * @param id of the member or controller that is to connect anyway
   * @throws SiteException when it does not, with its reason
   */
  public void requireLetIn(String id) {
    ConnectionTester door = new ConnectionTester(broker, ANSWER_WITHIN);
    security
        .map(files -> door.objection(files.password(id)))
        .orElseGet(door::objection)
        .ifPresent(
            reason -> {
              throw new SiteException(
                  "The broker %s does not let %s in: %s; %s."
                      .formatted(broker, id, reason, security.isPresent() ? OF_SITE : OPEN));
            });
  }

  private static void requireOf(String site, SiteSecurity files) {
    String secured = files.users().site();
    if (!secured.equals(site)) {
      throw new SiteException(
          "The security files are of the site %s, not of %s; name the site that they are for."
              .formatted(secured, site));
    }
  }

  /** The transports of members and controllers, by id. */
  public Function<String, Transport> transports() {
    return id ->
        security
            .map(files -> new PahoTransport(broker, files.password(id), admission))
            .orElseGet(() -> new PahoTransport(broker, site + "-" + id, admission));
  }

  /**
   * The connection of all members of this process that have their broker in it too.
   *
   * @throws SiteException when the site is secured, where each connects as itself
   */
  SharedConnection sharedByMembers() {
    if (security.isPresent()) {
      throw new SiteException("On a secured site each member connects as itself.");
    }
    Topics topics = new Topics(site);
    return new SharedConnection(
        new PahoTransport(broker, site + "-members", admission),
        topics.everything(),
        topics.retained());
  }

  public CallPolicy policy() {
    return security.<CallPolicy>map(SiteSecurity::rules).orElse(CallPolicy.OPEN);
  }

  public SiteKind kind() {
    return security.isPresent() ? SiteKind.SECURED : SiteKind.OPEN;
  }
}
