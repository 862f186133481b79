package org.maestro.platform.guard;

import jade.core.Profile;
import jade.util.leap.Properties;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.file.Path;
import java.security.cert.X509Certificate;
import java.time.Duration;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import javax.net.ssl.SSLException;
import javax.net.ssl.SSLSocket;
import org.maestro.rats.security.ContainerAccess;
import org.maestro.rats.security.SecurityFilesException;
import org.maestro.rats.security.SitePersons;
import org.maestro.rats.security.SiteSecurity;
import org.maestro.rats.security.WatchedFiles;

/**
 * A user's part in a secured site's platform: who lets other containers in, and is let in by them.
 * Whoever connects shows a certificate of the site and then the join token, before JADE reads a
 * byte. Any thread may use it.
 */
public final class Guard {
  private static final String FILES = "maestro-security-files";
  private static final String USER = "maestro-security-user";
  private static final String PROTOCOL = "TLSv1.3";
  private static final int MOST_OF_A_TOKEN = 512;
  private static final int CONNECTED_WITHIN_MILLIS = 5_000;

  /** Long enough for a slow machine, and all that a stranger can keep a thread for. */
  private static final int INTRODUCED_WITHIN_MILLIS = 5_000;

  /** How long it takes until what has changed in the site's files counts. */
  private static final Duration LOOKED_EVERY = Duration.ofMillis(500);

  private final SiteSecurity site;
  private final String user;
  private final WatchedFiles files;
  private final Refusals refusals = new Refusals();
  private final Set<SSLSocket> connected = ConcurrentHashMap.newKeySet();

  /** Both guarded by this. */
  private ContainerAccess access;

  private long lookedNanos = System.nanoTime();

  private Guard(SiteSecurity site, String user) {
    this.site = site;
    this.user = user;
    this.files = site.containerFiles(user);
    this.access = site.container(user);
  }

  /**
   * @param user a controller or guest of the site, whose process this is
   * @throws SecurityFilesException when the site has no such user, or its files cannot be used
   */
  public static Guard open(SiteSecurity site, String user) {
    return new Guard(site, user);
  }

  /**
   * Of the process that JADE starts by this profile.
   *
   * @throws SecurityFilesException when the files cannot be used
   */
  static Guard of(Profile profile) {
    return open(
        SiteSecurity.open(Path.of(profile.getParameter(FILES, ""))),
        profile.getParameter(USER, ""));
  }

  /** Writes down by which files and for whom a container of this process is guarded. */
  void writeTo(Properties profile) {
    profile.setProperty(FILES, site.directory().toString());
    profile.setProperty(USER, user);
  }

  /** As the site's files have it now; when they cannot be used, as they had it. */
  synchronized ContainerAccess access() {
    if (System.nanoTime() - lookedNanos > LOOKED_EVERY.toNanos()) {
      lookedNanos = System.nanoTime();
      if (files.haveChanged()) {
        try {
          access = SiteSecurity.open(site.directory()).container(user);
        } catch (SecurityFilesException unusable) {
          refusals.log("The security files stay as they were read: " + unusable.getMessage());
        }
      }
    }
    return access;
  }

  /** Whether the user may only ask, as the site's files have it now. */
  public boolean isGuest(String other) {
    return access().isGuest(other);
  }

  /**
   * The persons of the site.
   *
   * @throws SecurityFilesException when the files cannot be used
   */
  public SitePersons persons() {
    return site.persons();
  }

  /** Ends the connections of those who are containers of the site no more. */
  void cutRevoked() {
    connected.removeIf(this::isOver);
  }

  private boolean isOver(SSLSocket connection) {
    try {
      if (!connection.isClosed() && holder(connection).isEmpty()) {
        refusals.log(
            "The connection with %s ends: the certificate %s is no longer good."
                .formatted(
                    connection.getRemoteSocketAddress(),
                    connection.getSession().getPeerPrincipal()));
        connection.close();
      }
      return connection.isClosed();
    } catch (IOException gone) {
      return true;
    }
  }

  Refusals refusals() {
    return refusals;
  }

  /**
   * Whether this user would be let in there.
   *
   * @return why not, in one sentence
   */
  public Optional<String> objection(String host, int port) {
    try {
      connect(host, port, false).close();
      return Optional.empty();
    } catch (IOException refused) {
      return Optional.of(Objects.requireNonNullElse(refused.getMessage(), refused.toString()));
    }
  }

  /** Connects to another container, and is let in. */
  Socket call(String host, int port) throws IOException {
    return connect(host, port, true);
  }

  /**
   * @param stays false when it only wants to know whether it would be let in
   */
  private Socket connect(String host, int port, boolean stays) throws IOException {
    SSLSocket socket = (SSLSocket) access().tls().getSocketFactory().createSocket();
    try {
      socket.setEnabledProtocols(new String[] {PROTOCOL});
      socket.setTcpNoDelay(true);
      socket.connect(new InetSocketAddress(host, port), CONNECTED_WITHIN_MILLIS);
      socket.setSoTimeout(INTRODUCED_WITHIN_MILLIS);
      introduce(socket, host + ":" + port, stays);
      socket.setSoTimeout(0);
      if (stays) {
        connected.add(socket);
      }
      return socket;
    } catch (IOException refused) {
      socket.close();
      throw refused;
    }
  }

  private void introduce(SSLSocket socket, String address, boolean stays) throws IOException {
    try {
      socket.startHandshake();
      if (holder(socket).isEmpty()) {
        throw new IOException(
            "What answers at %s shows the certificate of nobody who may be a container of the site %s; see where it leads."
                .formatted(address, site.users().site()));
      }
      DataOutputStream out = new DataOutputStream(socket.getOutputStream());
      byte[] token = access().token();
      out.writeShort(token.length);
      out.write(token);
      out.writeBoolean(stays);
      out.flush();
      String refusal = new DataInputStream(socket.getInputStream()).readUTF();
      if (!refusal.isEmpty()) {
        throw new IOException(
            "The user %s was refused at %s: %s.".formatted(user, address, refusal));
      }
    } catch (SSLException notOfOneSite) {
      throw new IOException(
          "Nobody of the secured site %s answers at %s, or it does not know the certificate of the user %s (%s); see that both use the files of one site."
              .formatted(site.users().site(), address, user, notOfOneSite.getMessage()),
          notOfOneSite);
    }
  }

  /**
   * Lets in who has connected, and tells it so, or why not.
   *
   * @throws IOException when it went away, or spoke no TLS of the site
   */
  Admission admit(Socket stranger) throws IOException {
    stranger.setSoTimeout(INTRODUCED_WITHIN_MILLIS);
    stranger.setTcpNoDelay(true);
    SSLSocket socket =
        (SSLSocket)
            access()
                .tls()
                .getSocketFactory()
                .createSocket(
                    stranger, stranger.getInetAddress().getHostAddress(), stranger.getPort(), true);
    socket.setUseClientMode(false);
    socket.setNeedClientAuth(true);
    socket.setEnabledProtocols(new String[] {PROTOCOL});
    socket.startHandshake();
    DataInputStream in = new DataInputStream(socket.getInputStream());
    int length = in.readUnsignedShort();
    byte[] token = in.readNBytes(Math.min(length, MOST_OF_A_TOKEN));
    boolean stays = in.readBoolean();
    Optional<String> refusal = refusal(socket, token);
    DataOutputStream out = new DataOutputStream(socket.getOutputStream());
    out.writeUTF(refusal.orElse(""));
    out.flush();
    socket.setSoTimeout(0);
    if (refusal.isEmpty() && stays) {
      connected.add(socket);
    }
    return new Admission(socket, refusal, stays);
  }

  /**
   * The decision about somebody who has connected.
   *
   * @param socket over which it is heard
   * @param refusal why it was not let in, in a part of a sentence
   * @param stays false when it only wanted to know
   */
  record Admission(Socket socket, Optional<String> refusal, boolean stays) {}

  private Optional<String> refusal(SSLSocket socket, byte[] token) throws SSLException {
    Optional<String> holder = holder(socket);
    if (holder.isEmpty()) {
      return Optional.of(
          "its certificate is that of nobody who may be a container of the site "
              + site.users().site());
    }
    return access().isToken(token)
        ? Optional.empty()
        : Optional.of("%s does not show the site's join token".formatted(holder.get()));
  }

  private Optional<String> holder(SSLSocket socket) throws SSLException {
    return access().holder((X509Certificate) socket.getSession().getPeerCertificates()[0]);
  }
}
