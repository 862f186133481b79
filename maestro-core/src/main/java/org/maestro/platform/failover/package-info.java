/**
 * The right to act for a site, which one process has at a time, and what others do in the place of
 * those that are gone: links under their names, hosts for their agents, processes started again.
 * Signs of life flow in; who acts for whom flows out.
 */
@NullMarked
package org.maestro.platform.failover;

import org.jspecify.annotations.NullMarked;
