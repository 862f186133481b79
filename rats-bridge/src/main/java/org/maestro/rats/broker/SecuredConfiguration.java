package org.maestro.rats.broker;

import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.URIParameter;
import java.util.Map;
import java.util.Set;
import javax.security.auth.login.AppConfigurationEntry;
import javax.security.auth.login.Configuration;
import org.apache.activemq.artemis.api.core.TransportConfiguration;
import org.apache.activemq.artemis.core.config.impl.SecurityConfiguration;
import org.apache.activemq.artemis.core.deployers.impl.FileConfigurationParser;
import org.apache.activemq.artemis.core.remoting.impl.netty.TransportConstants;
import org.apache.activemq.artemis.core.security.Role;
import org.apache.activemq.artemis.spi.core.security.ActiveMQJAASSecurityManager;

/** The files of an Artemis that guards a site, as the embedded one uses them. */
final class SecuredConfiguration {

  /** As an Artemis of its own names them. */
  private static final String BY_PASSWORD = "activemq";

  private static final String BY_CERTIFICATE = "certificates";

  private final org.apache.activemq.artemis.core.config.Configuration broker;
  private final Configuration login;

  private SecuredConfiguration(
      org.apache.activemq.artemis.core.config.Configuration broker, Configuration login) {
    this.broker = broker;
    this.login = login;
  }

  static SecuredConfiguration read(Path directory) {
    Path broker = directory.resolve("broker.xml");
    Path login = directory.resolve("login.config");
    try (InputStream xml = Files.newInputStream(broker)) {
      return new SecuredConfiguration(
          new FileConfigurationParser().parseMainConfig(xml),
          Configuration.getInstance("JavaLoginConfig", new URIParameter(login.toUri())));
    } catch (Exception broken) {
      throw new BrokerStartException(
          "The security files %s and %s cannot be used; make them anew with ./maestro secure"
              .formatted(broker, login),
          broken);
    }
  }

  org.apache.activemq.artemis.core.config.Configuration configuration(String host, int port) {
    for (TransportConfiguration acceptor : broker.getAcceptorConfigurations()) {
      acceptor.getParams().put(TransportConstants.HOST_PROP_NAME, host);
      acceptor.getParams().put(TransportConstants.PORT_PROP_NAME, port);
    }
    broker.setName("rats-" + port);
    return broker;
  }

  /** Who may do what at which addresses. */
  Map<String, Set<Role>> rights() {
    return broker.getSecurityRoles();
  }

  ActiveMQJAASSecurityManager securityManager() {
    SecurityConfiguration entries = new FileEntries(login);
    return new ActiveMQJAASSecurityManager(BY_PASSWORD, BY_CERTIFICATE, entries, entries);
  }

  private static final class FileEntries extends SecurityConfiguration {
    private final Configuration file;

    private FileEntries(Configuration file) {
      this.file = file;
    }

    @Override
    public AppConfigurationEntry[] getAppConfigurationEntry(String name) {
      return file.getAppConfigurationEntry(name);
    }
  }
}
