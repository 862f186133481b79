package org.maestro.rats.broker;

import java.util.regex.Pattern;
import org.apache.activemq.artemis.api.core.ActiveMQException;
import org.apache.activemq.artemis.api.core.ActiveMQSecurityException;
import org.apache.activemq.artemis.api.core.Message;
import org.apache.activemq.artemis.core.protocol.mqtt.MQTTUtil;
import org.apache.activemq.artemis.core.server.ServerSession;
import org.apache.activemq.artemis.core.server.plugin.ActiveMQServerPlugin;
import org.apache.activemq.artemis.core.transaction.Transaction;

/**
 * Refuses calls that are published with the retain flag, so that their publisher learns of it:
 * nobody may execute them, and Artemis does not tell the members of the flag, as Retain As
 * Published has no effect on its subscriptions with wildcards. For Artemis, which makes it by its
 * name in broker.xml.
 */
public final class NoRetainedCalls implements ActiveMQServerPlugin {

  /** Artemis writes a dot within a level with a backslash. */
  private static final Pattern CALLS =
      Pattern.compile("rats\\.1\\.(?:[^.\\\\]|\\\\.)+\\.call(?:\\..*)?");

  @Override
  public void beforeSend(
      ServerSession session,
      Transaction transaction,
      Message message,
      boolean direct,
      boolean noAutoCreateQueue)
      throws ActiveMQException {
    Object retained = message.getObjectProperty(MQTTUtil.MQTT_MESSAGE_RETAIN_KEY);
    if (Boolean.TRUE.equals(retained) && CALLS.matcher(message.getAddress()).matches()) {
      throw new ActiveMQSecurityException("A call must not be retained: " + message.getAddress());
    }
  }
}
