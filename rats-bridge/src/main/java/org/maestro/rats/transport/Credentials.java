package org.maestro.rats.transport;

import java.util.Optional;
import javax.net.ssl.SSLContext;

/**
 * A client's password or certificate for a secured broker. Its text tells the user only.
 *
 * @param user also the client id
 * @param password empty: the context holds the user's certificate
 * @param tls whom the client trusts
 */
public record Credentials(String user, Optional<String> password, SSLContext tls) {

  @Override
  public String toString() {
    return "credentials of " + user;
  }
}
