package org.maestro.bench.bus;

import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.net.URI;
import java.util.function.BiConsumer;
import javax.net.SocketFactory;
import org.eclipse.paho.mqttv5.client.IMqttToken;
import org.eclipse.paho.mqttv5.client.MqttAsyncClient;
import org.eclipse.paho.mqttv5.client.MqttCallback;
import org.eclipse.paho.mqttv5.client.MqttConnectionOptions;
import org.eclipse.paho.mqttv5.client.MqttDisconnectResponse;
import org.eclipse.paho.mqttv5.client.persist.MemoryPersistence;
import org.eclipse.paho.mqttv5.common.MqttException;
import org.eclipse.paho.mqttv5.common.MqttMessage;
import org.eclipse.paho.mqttv5.common.packet.MqttProperties;

/** The MQTT client alone, without the bus: what the bus is compared with. */
final class BarePaho implements MqttCallback, AutoCloseable {
  private static final long WAIT_MILLIS = 10_000;
  private static final int MOST_UNDER_WAY = 1_000;

  private final MqttAsyncClient client;
  private final BiConsumer<String, byte[]> arrived;

  BarePaho(URI broker, String id, String filter, BiConsumer<String, byte[]> arrived) {
    this.arrived = arrived;
    try {
      client = new MqttAsyncClient(broker.toString(), id, new MemoryPersistence());
      client.setCallback(this);
      MqttConnectionOptions options = new MqttConnectionOptions();
      options.setCleanStart(true);
      options.setReceiveMaximum(MOST_UNDER_WAY);
      options.setSocketFactory(new AtOnce());
      client.connect(options).waitForCompletion(WAIT_MILLIS);
      client.subscribe(filter, 1).waitForCompletion(WAIT_MILLIS);
    } catch (MqttException e) {
      throw new IllegalStateException("The bare client cannot connect: " + e.getMessage(), e);
    }
  }

  void publish(String topic, byte[] payload) {
    try {
      client.publish(topic, payload, 1, false);
    } catch (MqttException e) {
      throw new IllegalStateException("The bare client cannot publish: " + e.getMessage(), e);
    }
  }

  @Override
  public void close() {
    try {
      client.disconnect().waitForCompletion(WAIT_MILLIS);
      client.close();
    } catch (MqttException e) {
      throw new IllegalStateException("The bare client cannot leave: " + e.getMessage(), e);
    }
  }

  @Override
  public void messageArrived(String topic, MqttMessage message) {
    arrived.accept(topic, message.getPayload());
  }

  @Override
  public void disconnected(MqttDisconnectResponse response) {
    // A benchmark whose broker goes ends by its own time limit.
  }

  @Override
  public void mqttErrorOccurred(MqttException exception) {
    // The same.
  }

  @Override
  public void deliveryComplete(IMqttToken token) {
    // Only what arrives counts.
  }

  @Override
  public void connectComplete(boolean reconnect, String serverUri) {
    // The constructor waits for it.
  }

  @Override
  public void authPacketArrived(int reasonCode, MqttProperties properties) {
    // Not used.
  }

  /** Sockets without delay, as the bus has them. */
  private static final class AtOnce extends SocketFactory {
    @Override
    public Socket createSocket() throws IOException {
      Socket socket = new Socket();
      socket.setTcpNoDelay(true);
      return socket;
    }

    @Override
    public Socket createSocket(String host, int port) throws IOException {
      return new Socket(host, port);
    }

    @Override
    public Socket createSocket(String host, int port, InetAddress local, int localPort)
        throws IOException {
      return new Socket(host, port, local, localPort);
    }

    @Override
    public Socket createSocket(InetAddress host, int port) throws IOException {
      return new Socket(host, port);
    }

    @Override
    public Socket createSocket(InetAddress host, int port, InetAddress local, int localPort)
        throws IOException {
      return new Socket(host, port, local, localPort);
    }
  }
}
