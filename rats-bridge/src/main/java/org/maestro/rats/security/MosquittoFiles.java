package org.maestro.rats.security;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * The files with which mosquitto guards a site: its configuration, password file and access list.
 */
final class MosquittoFiles {

  static final int PASSWORD_PORT = 8883;
  static final int CERTIFICATE_PORT = 8884;

  private final SiteUsers users;
  private final Path directory;

  /**
   * @param directory of all the site's security files
   */
  MosquittoFiles(SiteUsers users, Path directory) {
    this.users = users;
    this.directory = directory;
  }

  /** By name below the directory. */
  Map<String, String> texts(Map<String, String> passwords) {
    Map<String, String> texts = new LinkedHashMap<>();
    texts.put("mosquitto/mosquitto.conf", configuration());
    texts.put("mosquitto/acl", accessList());
    StringBuilder hashes = new StringBuilder();
    passwords.forEach(
        (id, password) ->
            hashes.append(id).append(':').append(PasswordHashes.mosquitto(password)).append('\n'));
    texts.put("mosquitto/passwords", hashes.toString());
    return texts;
  }

  private String configuration() {
    return """
    # mosquitto -c %1$s/mosquitto/mosquitto.conf
    # These files are open to their owner only, so that is whom mosquitto runs as.
    # Users with a password come to %2$d, those with a certificate to %3$d.
    user %4$s
    per_listener_settings false
    allow_anonymous false
    password_file %1$s/mosquitto/passwords
    acl_file %1$s/mosquitto/acl
    persistence false
    set_tcp_nodelay true
    max_queued_messages 10000

    listener %2$d
    cafile %1$s/ca/ca.pem
    crlfile %1$s/ca/revoked.pem
    certfile %1$s/broker/certificate.pem
    keyfile %1$s/broker/key.pem
    use_username_as_clientid true

    listener %3$d
    cafile %1$s/ca/ca.pem
    crlfile %1$s/ca/revoked.pem
    certfile %1$s/broker/certificate.pem
    keyfile %1$s/broker/key.pem
    require_certificate true
    use_identity_as_username true
    use_username_as_clientid true
    """
        .formatted(directory, PASSWORD_PORT, CERTIFICATE_PORT, System.getProperty("user.name"));
  }

  private String accessList() {
    StringBuilder list = new StringBuilder("# What nothing here allows is refused.\n");
    for (String id : users.all()) {
      list.append("\nuser ").append(id).append('\n');
      TopicRights rights = TopicRights.of(users, id);
      rights.write().forEach(topic -> list.append("topic write ").append(topic).append('\n'));
      rights.read().forEach(topic -> list.append("topic read ").append(topic).append('\n'));
    }
    return list.toString();
  }
}
