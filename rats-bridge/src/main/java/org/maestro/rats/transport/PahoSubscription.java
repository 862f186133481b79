package org.maestro.rats.transport;

import org.eclipse.paho.mqttv5.common.MqttSubscription;

/** A subscription of {@link PahoTransport}, as it is and as Paho sends it. */
record PahoSubscription(
    TopicFilter filter,
    Transport.RetainedMessages retained,
    Transport.MessageHandler handler,
    boolean ofOthers) {

  private static final int SEND_AT_SUBSCRIBE = 0;
  private static final int DO_NOT_SEND = 2;

  MqttSubscription wire() {
    MqttSubscription subscription = new MqttSubscription(filter.text(), 1);
    subscription.setNoLocal(ofOthers);
    subscription.setRetainAsPublished(true);
    subscription.setRetainHandling(
        retained == Transport.RetainedMessages.SEND ? SEND_AT_SUBSCRIBE : DO_NOT_SEND);
    return subscription;
  }
}
