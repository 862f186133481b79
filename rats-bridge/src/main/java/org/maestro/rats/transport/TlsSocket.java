package org.maestro.rats.transport;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.SocketAddress;
import java.net.SocketException;
import javax.net.ssl.SSLContext;
import javax.net.ssl.SSLParameters;
import javax.net.ssl.SSLSocket;
import org.jspecify.annotations.Nullable;

/** The patient socket over TLS: it connects, shakes hands, and makes sure of the broker's name. */
final class TlsSocket extends PatientSocket {

  private final SSLContext context;
  private final Socket plain = new Socket();
  private volatile @Nullable SSLSocket secured;

  TlsSocket(SSLContext context) throws IOException {
    this.context = context;
    plain.setTcpNoDelay(true);
  }

  @Override
  public void connect(SocketAddress endpoint, int timeoutMillis) throws IOException {
    InetSocketAddress broker = (InetSocketAddress) endpoint;
    plain.connect(endpoint, timeoutMillis);
    plain.setSoTimeout(timeoutMillis);
    SSLSocket socket =
        (SSLSocket)
            context
                .getSocketFactory()
                .createSocket(plain, broker.getHostString(), broker.getPort(), true);
    SSLParameters parameters = socket.getSSLParameters();
    parameters.setEndpointIdentificationAlgorithm("HTTPS");
    socket.setSSLParameters(parameters);
    socket.startHandshake();
    plain.setSoTimeout(0);
    secured = socket;
  }

  @Override
  public void connect(SocketAddress endpoint) throws IOException {
    connect(endpoint, 0);
  }

  @Override
  InputStream bareInput() throws IOException {
    return connected().getInputStream();
  }

  @Override
  OutputStream bareOutput() throws IOException {
    return connected().getOutputStream();
  }

  @Override
  public synchronized void setSoTimeout(int millis) throws SocketException {
    plain.setSoTimeout(millis);
  }

  @Override
  public synchronized int getSoTimeout() throws SocketException {
    return plain.getSoTimeout();
  }

  @Override
  public synchronized void close() throws IOException {
    try {
      plain.close();
    } finally {
      super.close();
    }
  }

  private SSLSocket connected() throws IOException {
    SSLSocket socket = secured;
    if (socket == null) {
      throw new SocketException("the socket is not connected");
    }
    return socket;
  }
}
