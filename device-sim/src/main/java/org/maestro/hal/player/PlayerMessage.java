package org.maestro.hal.player;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;

/**
 * A message of Player's protocol, versions 2 and 3: a header of 40 bytes and a body, each number of
 * both in XDR (RFC 4506), where the smallest takes four bytes. Immutable.
 */
final class PlayerMessage {

  /** What the server says of itself when somebody connects. */
  static final int BANNER_BYTES = 32;

  /** Longer than any that is of use here; a longer one is not of this protocol. */
  private static final int MOST_BYTES = 1 << 20;

  /** Kinds of messages, by their numbers. */
  static final int DATA = 1;

  static final int COMMAND = 2;
  static final int REQUEST = 3;
  static final int REFUSED = 6;

  /** The interfaces that are used here: the server itself, and a base on the floor. */
  static final int SERVER = 1;

  static final int POSITION_2D = 4;

  private final int interfaceCode;
  private final int index;
  private final int type;
  private final int subtype;
  private final byte[] body;

  private PlayerMessage(int interfaceCode, int index, int type, int subtype, byte[] body) {
    this.interfaceCode = interfaceCode;
    this.index = index;
    this.type = type;
    this.subtype = subtype;
    this.body = body;
  }

  /** Writes a message's body. */
  interface Body {
    void write(DataOutputStream out) throws IOException;
  }

  static PlayerMessage of(int interfaceCode, int index, int type, int subtype, Body body) {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try {
      body.write(new DataOutputStream(bytes));
    } catch (IOException impossible) {
      throw new UncheckedIOException(impossible);
    }
    return new PlayerMessage(interfaceCode, index, type, subtype, bytes.toByteArray());
  }

  /**
   * @throws IOException when the stream ends, or what comes is no such message
   */
  static PlayerMessage read(DataInputStream in) throws IOException {
    in.readInt(); // the host, which each server knows as its own
    in.readInt(); // its port
    int interfaceCode = in.readInt();
    int index = in.readInt();
    int type = in.readInt();
    int subtype = in.readInt();
    in.readDouble(); // the time, which some servers count from when they began
    in.readInt(); // the number in sequence
    int size = in.readInt();
    if (size < 0 || size > MOST_BYTES) {
      throw new IOException("it says that a message has " + size + " bytes");
    }
    byte[] body = in.readNBytes(size);
    if (body.length < size) {
      throw new IOException("it ended within a message");
    }
    return new PlayerMessage(interfaceCode, index, type, subtype, body);
  }

  void write(DataOutputStream out) throws IOException {
    out.writeInt(0);
    out.writeInt(0);
    out.writeInt(interfaceCode);
    out.writeInt(index);
    out.writeInt(type);
    out.writeInt(subtype);
    out.writeDouble(0);
    out.writeInt(0);
    out.writeInt(body.length);
    out.write(body);
    out.flush();
  }

  boolean is(int ofInterface, int ofType, int ofSubtype) {
    return interfaceCode == ofInterface && type == ofType && subtype == ofSubtype;
  }

  int index() {
    return index;
  }

  DataInputStream body() {
    return new DataInputStream(new ByteArrayInputStream(body));
  }
}
