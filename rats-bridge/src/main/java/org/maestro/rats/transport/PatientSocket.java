package org.maestro.rats.transport;

import java.io.BufferedInputStream;
import java.io.FilterInputStream;
import java.io.FilterOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.InterruptedIOException;
import java.io.OutputStream;
import java.net.Socket;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;

/**
 * A socket that sends at once, and makes up for two haste faults. Paho 1.2.5 looks for its reader
 * every 100 ms while it starts, and looks for ever when the reader has ended by then: so the reader
 * learns of a broken connection only after something was written, which is when Paho has started.
 * And Paho closes right behind its DISCONNECT, which Artemis at times takes for a broken
 * connection, so that it publishes the will: so the broker gets some time to close first, as MQTT 5
 * has it.
 */
class PatientSocket extends Socket {

  private static final long LONGEST_START_SECONDS = 5;

  private static final long BROKER_CLOSES_MILLIS = 300;

  private final CountDownLatch written = new CountDownLatch(1);
  private final CountDownLatch ended = new CountDownLatch(1);

  private Optional<InputStream> input = Optional.empty();

  PatientSocket() throws IOException {
    setTcpNoDelay(true);
  }

  /** What the bytes of MQTT come from. */
  InputStream bareInput() throws IOException {
    return super.getInputStream();
  }

  OutputStream bareOutput() throws IOException {
    return super.getOutputStream();
  }

  /**
   * Buffered, as Paho reads each message in four pieces and asks before each whether there is any.
   */
  @Override
  public synchronized InputStream getInputStream() throws IOException {
    if (input.isEmpty()) {
      input = Optional.of(patient(new AtHand(bareInput())));
    }
    return input.get();
  }

  private InputStream patient(InputStream bare) {
    return new FilterInputStream(bare) {
      @Override
      public int available() throws IOException {
        try {
          return super.available();
        } catch (IOException broken) {
          throw afterStart(broken);
        }
      }

      @Override
      public int read() throws IOException {
        try {
          return orEnd(super.read());
        } catch (IOException broken) {
          throw afterStart(broken);
        }
      }

      @Override
      public int read(byte[] bytes, int offset, int length) throws IOException {
        try {
          return orEnd(super.read(bytes, offset, length));
        } catch (IOException broken) {
          throw afterStart(broken);
        }
      }
    };
  }

  @Override
  public OutputStream getOutputStream() throws IOException {
    return new FilterOutputStream(bareOutput()) {
      @Override
      public void write(int single) throws IOException {
        written.countDown();
        out.write(single);
      }

      @Override
      public void write(byte[] bytes, int offset, int length) throws IOException {
        written.countDown();
        out.write(bytes, offset, length);
      }
    };
  }

  /** Called by Paho before it closes. */
  @Override
  public void shutdownInput() {
    try {
      ended.await(BROKER_CLOSES_MILLIS, TimeUnit.MILLISECONDS);
    } catch (InterruptedException interrupted) {
      Thread.currentThread().interrupt();
    }
  }

  @Override
  public synchronized void close() throws IOException {
    ended.countDown();
    super.close();
  }

  /** A buffered stream that asks the system nothing while bytes are in its buffer. */
  private static final class AtHand extends BufferedInputStream {
    private AtHand(InputStream bare) {
      super(bare);
    }

    @Override
    public synchronized int available() throws IOException {
      int buffered = count - pos;
      return buffered > 0 ? buffered : super.available();
    }
  }

  private int orEnd(int result) throws IOException {
    if (result < 0) {
      ended.countDown();
      awaitStart();
    }
    return result;
  }

  private IOException afterStart(IOException broken) throws IOException {
    ended.countDown();
    awaitStart();
    return broken;
  }

  private void awaitStart() throws IOException {
    try {
      if (!written.await(LONGEST_START_SECONDS, TimeUnit.SECONDS)) {
        throw new IOException("the client did not start in time");
      }
    } catch (InterruptedException interrupted) {
      Thread.currentThread().interrupt();
      throw new InterruptedIOException("the client stopped while it started");
    }
  }
}
