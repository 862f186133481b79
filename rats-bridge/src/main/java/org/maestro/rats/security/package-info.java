/**
 * What makes a site a secured one: its certificate authority, users, passwords and rules, as files
 * that {@code maestro secure} writes and that brokers, members and controllers read. Files flow in
 * and out, credentials and the rules of calls flow to members and links. Secrets leave it only
 * inside credentials, whose text hides them.
 */
@NullMarked
package org.maestro.rats.security;

import org.jspecify.annotations.NullMarked;
