package org.maestro.platform.guard;

import static java.nio.charset.StandardCharsets.UTF_8;

import jade.core.AID;
import jade.lang.acl.ACLMessage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.security.GeneralSecurityException;
import java.security.cert.CertificateFactory;
import java.security.cert.X509Certificate;
import java.util.Base64;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import org.maestro.rats.security.ContainerAccess;

/**
 * The signature of a message by the process whose agent has sent it, in a slot that people can see
 * in the sniffer.
 *
 * @param life of the process
 * @param number of the message in that life
 */
record Seal(String life, long number, X509Certificate certificate, byte[] signature) {
  /** The slot that holds it. */
  static final String SLOT = "X-maestro-seal";

  private static final String VERSION = "1";
  private static final int PARTS = 5;

  static Seal of(
      ACLMessage message, AID receiver, String life, long number, ContainerAccess access) {
    return new Seal(
        life, number, access.certificate(), access.sign(text(message, receiver, life, number)));
  }

  boolean fits(ACLMessage message, AID receiver) {
    return ContainerAccess.isSigned(text(message, receiver, life, number), signature, certificate);
  }

  String write() {
    Base64.Encoder base64 = Base64.getUrlEncoder().withoutPadding();
    try {
      return String.join(
          ".",
          List.of(
              VERSION,
              life,
              Long.toString(number),
              base64.encodeToString(certificate.getEncoded()),
              base64.encodeToString(signature)));
    } catch (GeneralSecurityException broken) {
      throw new IllegalStateException("A certificate that was read cannot be written", broken);
    }
  }

  /** What {@link #write} wrote; empty when it is none. */
  static Optional<Seal> read(String text) {
    String[] parts = text.split("\\.");
    if (parts.length != PARTS || !parts[0].equals(VERSION)) {
      return Optional.empty();
    }
    try {
      Base64.Decoder base64 = Base64.getUrlDecoder();
      return Optional.of(
          new Seal(
              parts[1],
              Long.parseLong(parts[2]),
              certificate(base64.decode(parts[3])),
              base64.decode(parts[4])));
    } catch (IllegalArgumentException | GeneralSecurityException | ClassCastException none) {
      return Optional.empty();
    }
  }

  static X509Certificate certificate(byte[] encoded) throws GeneralSecurityException {
    return (X509Certificate)
        CertificateFactory.getInstance("X.509")
            .generateCertificate(new ByteArrayInputStream(encoded));
  }

  /** All that a receiver goes by, each part with its length before it. */
  private static byte[] text(ACLMessage message, AID receiver, String life, long number) {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (DataOutputStream out = new DataOutputStream(bytes)) {
      part(out, VERSION);
      part(out, life);
      out.writeLong(number);
      part(out, message.getSender().getName());
      part(out, receiver.getName());
      out.writeInt(message.getPerformative());
      part(out, message.getLanguage());
      part(out, message.getOntology());
      part(out, message.getEncoding());
      part(out, message.getProtocol());
      part(out, message.getConversationId());
      part(out, message.getReplyWith());
      part(out, message.getInReplyTo());
      out.writeLong(
          message.getReplyByDate() == null
              ? 0
              : message.getReplyByDate().toInstant().toEpochMilli());
      for (Iterator<?> answered = message.getAllReplyTo(); answered.hasNext(); ) {
        part(out, ((AID) answered.next()).getName());
      }
      byte[] sequence = message.hasByteSequenceContent() ? message.getByteSequenceContent() : null;
      part(out, sequence == null ? bytes(message.getContent()) : sequence);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return bytes.toByteArray();
  }

  private static void part(DataOutputStream out, String text) throws IOException {
    part(out, bytes(text));
  }

  private static void part(DataOutputStream out, byte[] part) throws IOException {
    out.writeInt(part.length);
    out.write(part);
  }

  /** What is empty and what is not there are not told apart by all encodings. */
  private static byte[] bytes(String text) {
    return text == null ? new byte[0] : text.getBytes(UTF_8);
  }
}
