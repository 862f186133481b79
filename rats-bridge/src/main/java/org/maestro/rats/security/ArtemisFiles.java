package org.maestro.rats.security;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.StringJoiner;

/**
 * The files with which Artemis guards a site. Of several matches Artemis takes only the best one,
 * so each address of a user has a setting of its own.
 */
final class ArtemisFiles {

  static final int PORT = 8883;

  private static final String MEMBERS = "members";
  private static final String CONTROLLERS = "controllers";
  private static final String OBSERVERS = "observers";
  private static final String EVERYBODY = MEMBERS + "," + CONTROLLERS;
  private static final String NOBODY = "";

  private final SiteUsers users;
  private final Path directory;
  private final String root;

  /**
   * @param directory of all the site's security files
   */
  ArtemisFiles(SiteUsers users, Path directory) {
    this.users = users;
    this.directory = directory;
    this.root = "rats.1." + escaped(users.site()) + ".";
  }

  /** By name below the directory. */
  Map<String, String> texts(Map<String, String> passwords, String storePassword) {
    Map<String, String> texts = new LinkedHashMap<>();
    texts.put("artemis/broker.xml", broker(storePassword));
    texts.put("artemis/login.config", login());
    StringBuilder hashes = new StringBuilder();
    passwords.forEach(
        (id, password) ->
            hashes.append(id).append(" = ").append(PasswordHashes.artemis(password)).append('\n'));
    texts.put("artemis/users.properties", hashes.toString());
    StringBuilder names = new StringBuilder();
    users.all().forEach(id -> names.append(id).append(" = CN=").append(id).append('\n'));
    texts.put("artemis/certificates.properties", names.toString());
    texts.put("artemis/roles.properties", roles());
    return texts;
  }

  private String roles() {
    StringBuilder roles = new StringBuilder();
    roles.append(MEMBERS).append(" = ").append(String.join(",", users.members())).append('\n');
    roles.append(CONTROLLERS).append(" = ").append(String.join(",", users.controllers()));
    roles.append('\n');
    if (!users.observers().isEmpty()) {
      roles.append(OBSERVERS).append(" = ").append(String.join(",", users.observers()));
      roles.append('\n');
    }
    users.all().forEach(id -> roles.append(role(id)).append(" = ").append(id).append('\n'));
    return roles.toString();
  }

  private String login() {
    return """
    activemq {
      org.apache.activemq.artemis.spi.core.security.jaas.PropertiesLoginModule required
        baseDir="%1$s/artemis"
        reload=true
        org.apache.activemq.jaas.properties.user="users.properties"
        org.apache.activemq.jaas.properties.role="roles.properties";
    };
    certificates {
      org.apache.activemq.artemis.spi.core.security.jaas.TextFileCertificateLoginModule required
        baseDir="%1$s/artemis"
        reload=true
        org.apache.activemq.jaas.textfiledn.user="certificates.properties"
        org.apache.activemq.jaas.textfiledn.role="roles.properties";
    };
    """
        .formatted(directory);
  }

  private String broker(String storePassword) {
    return """
    <?xml version="1.0" encoding="UTF-8"?>
    <!-- For Artemis 2.40 and newer: its login.config is beside this file, and the jar of
         rats-bridge belongs into its lib folder for the interceptor and the plugin. -->
    <configuration xmlns="urn:activemq">
      <core xmlns="urn:activemq:core">
        <name>rats</name>
        <persistence-enabled>false</persistence-enabled>
        <connection-ttl-check-interval>200</connection-ttl-check-interval>
        <message-expiry-scan-period>2000</message-expiry-scan-period>
        <security-enabled>true</security-enabled>
        <jmx-management-enabled>false</jmx-management-enabled>
        <journal-pool-files>10</journal-pool-files>
        <max-disk-usage>-1</max-disk-usage>
        <remoting-incoming-interceptors>
          <class-name>org.maestro.rats.broker.OwnNameOnly</class-name>
        </remoting-incoming-interceptors>
        <broker-plugins>
          <broker-plugin class-name="org.maestro.rats.broker.NoRetainedCalls"/>
        </broker-plugins>
        <acceptors>
          <acceptor name="mqtt">tcp://0.0.0.0:%2$d?protocols=MQTT;tcpNoDelay=true;sslEnabled=true;wantClientAuth=true;keyStoreType=PKCS12;keyStorePath=%1$s/broker/broker.p12;keyStorePassword=%3$s;trustStoreType=PKCS12;trustStorePath=%1$s/broker/trust.p12;trustStorePassword=%3$s;crlPath=%1$s/ca/revoked.pem</acceptor>
        </acceptors>
        <address-settings>
          <address-setting match="#">
            <dead-letter-address>dead-letters</dead-letter-address>
            <expiry-address>expired</expiry-address>
          </address-setting>
        </address-settings>
        <security-settings>
    %4$s    </security-settings>
      </core>
    </configuration>
    """
        .formatted(directory, PORT, storePassword, settings());
  }

  private String settings() {
    Settings settings = new Settings();
    settings.add("#", NOBODY, NOBODY);
    settings.add(root + "#", NOBODY, OBSERVERS);
    settings.add(root + "call.#", NOBODY, EVERYBODY);
    settings.add(root + "controller.*.status", NOBODY, EVERYBODY);
    settings.add(root + "member.#", NOBODY, CONTROLLERS);
    settings.add(root + "member.*.status", NOBODY, EVERYBODY);
    settings.add(root + "member.*.description", NOBODY, EVERYBODY);
    settings.add(root + "member.*.state", NOBODY, CONTROLLERS);
    settings.add(root + "member.*.observation.*", NOBODY, CONTROLLERS);
    for (String id : users.all()) {
      if (users.observers().contains(id)) {
        continue;
      }
      String role = role(id);
      String level = escaped(id);
      settings.add(root + "call." + level, role, EVERYBODY);
      settings.add(root + "result." + level + ".#", NOBODY, role);
      settings.add(root + "result.*." + level, role, NOBODY);
      settings.add(root + "progress." + level + ".#", NOBODY, role);
      settings.add(root + "progress.*." + level, role, NOBODY);
      if (users.controllers().contains(id)) {
        settings.add(root + "controller." + level + ".status", role, EVERYBODY);
      } else {
        String own = root + "member." + level + ".";
        String readers = role + "," + CONTROLLERS;
        settings.add(own + "status", role, EVERYBODY);
        settings.add(own + "description", role, EVERYBODY);
        settings.add(own + "state", role, readers);
        settings.add(own + "observation.*", role, readers);
        settings.add(own + "#", role, readers);
      }
    }
    return settings.toString();
  }

  private static String role(String id) {
    return "user-" + id;
  }

  /** Artemis separates levels by dots, and writes a dot within a level with a backslash. */
  private static String escaped(String level) {
    return level.replace(".", "\\.");
  }

  private static final class Settings {
    private final StringJoiner xml = new StringJoiner("");

    void add(String match, String writers, String readers) {
      xml.add("      <security-setting match=\"" + match + "\">\n");
      String both =
          writers.isEmpty() || readers.isEmpty() ? writers + readers : writers + "," + readers;
      if (!writers.isEmpty()) {
        permission("send", writers);
      }
      if (!readers.isEmpty()) {
        permission("consume", readers);
        permission("createNonDurableQueue", readers);
        permission("deleteNonDurableQueue", readers);
        permission("createDurableQueue", readers);
        permission("deleteDurableQueue", readers);
      }
      if (!both.isEmpty()) {
        permission("createAddress", both);
        permission("deleteAddress", both);
      }
      xml.add("      </security-setting>\n");
    }

    private void permission(String type, String roles) {
      xml.add("        <permission type=\"" + type + "\" roles=\"" + roles + "\"/>\n");
    }

    @Override
    public String toString() {
      return xml.toString();
    }
  }
}
