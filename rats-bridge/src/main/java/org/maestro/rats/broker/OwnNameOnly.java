package org.maestro.rats.broker;

import io.netty.handler.codec.mqtt.MqttConnectMessage;
import io.netty.handler.codec.mqtt.MqttConnectPayload;
import io.netty.handler.codec.mqtt.MqttMessage;
import java.security.Principal;
import java.util.Optional;
import java.util.regex.Pattern;
import org.apache.activemq.artemis.core.protocol.mqtt.MQTTInterceptor;
import org.apache.activemq.artemis.spi.core.protocol.RemotingConnection;
import org.apache.activemq.artemis.utils.CertificateUtil;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Lets clients of a secured site connect only under the name that they show credentials for, so
 * that nobody can push another off the bus, and only with a last will of their own, which Artemis
 * does not check. For Artemis, which makes it by its name in broker.xml.
 */
public final class OwnNameOnly implements MQTTInterceptor {

  private static final Logger LOG = LoggerFactory.getLogger(OwnNameOnly.class);

  @Override
  public boolean intercept(MqttMessage packet, RemotingConnection connection) {
    return !(packet instanceof MqttConnectMessage connect) || isOwn(connect, connection);
  }

  private static boolean isOwn(MqttConnectMessage connect, RemotingConnection connection) {
    MqttConnectPayload said = connect.payload();
    String user = certified(connection).or(() -> Optional.ofNullable(said.userName())).orElse("");
    String client = said.clientIdentifier();
    boolean ownName = !user.isEmpty() && user.equals(client);
    boolean ownWill =
        !connect.variableHeader().isWillFlag()
            || Pattern.matches(
                "rats/1/[^/]+/(member|controller)/" + Pattern.quote(user) + "/status",
                said.willTopic());
    if (!ownName || !ownWill) {
      LOG.warn(
          "The user {} is refused: it wants {} of another",
          user,
          ownName ? "a last will" : "the client id");
    }
    return ownName && ownWill;
  }

  private static Optional<String> certified(RemotingConnection connection) {
    return Optional.ofNullable(CertificateUtil.getPeerPrincipalFromConnection(connection))
        .map(Principal::getName)
        .filter(name -> name.startsWith("CN="))
        .map(name -> name.substring("CN=".length()));
  }
}
